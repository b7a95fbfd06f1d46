// Estimators side by side over a recording, and the control-loop error in place of the current.
#include "estimator/evaluation/compare_estimators.h"

#include <gtest/gtest.h>

#include "estimator/evaluation/loop_error.h"
#include "tests/estimator/evaluation/bench_top.h"

namespace searig::estimator {
namespace {

constexpr EstimatorKind all[] = {EstimatorKind::paper, EstimatorKind::moments,
                                 EstimatorKind::linear, EstimatorKind::rls};

EvaluationOptions everything(std::vector<std::string> states) {
  return {.initial_k_nm_per_rad = 80,
          .estimators = {std::begin(all), std::end(all)},
          .states = std::move(states)};
}

TEST(CompareEstimators, AllFindTheStiffnessAndOnlyLinearOnesHaveIntervals) {
  const BenchTop bench;
  const Model model = bench.model();
  const Evaluation e =
      evaluate(bench.record(60), &model, everything({"spring.linear", "spring.viscous"}));
  ASSERT_EQ(e.estimators.size(), 4u);
  for (const EstimatorResult& result : e.estimators) {
    EXPECT_NEAR(result.parameters[0].value, bench.k, 0.02 * bench.k) << name_of(result.kind);
    EXPECT_LT(result.score.error_percent, 8) << name_of(result.kind);
    const bool linear = result.kind == EstimatorKind::linear || result.kind == EstimatorKind::rls;
    EXPECT_EQ(result.why_no_interval.empty(), linear) << name_of(result.kind);
  }
}

TEST(CompareEstimators, PaperWithOneStateIsTheOnlineEstimate) {
  const BenchTop bench;
  const Model model = bench.model();
  const Evaluation e = evaluate(bench.record(20), &model, everything({"spring.linear"}));
  EXPECT_EQ(e.estimators[0].parameters[0].value, e.online->k_nm_per_rad);
  EXPECT_EQ(e.estimators[0].score.rmse_nm, e.online->score.rmse_nm);
}

TEST(CompareEstimators, SaysWhichCannot) {
  const BenchTop bench;
  const Model model = bench.model();
  const Evaluation e =
      evaluate(bench.record(20), &model, everything({"spring.linear", "spring.mullins"}));
  EXPECT_EQ(e.estimators.size(), 3u);
  EXPECT_NE(e.notes.back().find("rls is left out"), std::string::npos);
  const Evaluation lacking =
      evaluate(bench.record(20), &model, everything({"spring.linear", "spring.temperature"}));
  EXPECT_TRUE(lacking.estimators.empty());
  EXPECT_NE(lacking.notes.back().find("spring_temperature_c"), std::string::npos);
}

// A proportional loop of 25 A/rad: the commanded angle is where it must be for that current.
Signals with_loop(const BenchTop& bench, double gain) {
  Signals s = bench.record(40);
  for (std::size_t i = 0; i < s.module.t_s.size(); ++i) {
    s.module.commanded_angle_rad.push_back(s.module.input_angle_rad[i] +
                                           s.module.current_a[i] / gain);
  }
  s.module.current_a.clear();
  return s;
}

TEST(LoopError, StandsForTheCurrentWhereTheLoopsGainIsKnown) {
  const BenchTop bench;
  const Model model = bench.model();
  const EvaluationOptions options{
      .initial_k_nm_per_rad = 80, .drive = DriveTerms::loop, .loop_gain_a_per_rad = 25};
  const Evaluation e = evaluate(with_loop(bench, 25), &model, options);
  ASSERT_TRUE(e.online);
  EXPECT_NEAR(e.online->k_nm_per_rad, bench.k, 0.02 * bench.k);
  EXPECT_TRUE(e.drive_independent);
}

TEST(LoopError, IsFittedToTheLoadCellWhereItsGainIsNot) {
  const BenchTop bench{.friction = 0};
  const Model model = bench.model();
  const EvaluationOptions options{.initial_k_nm_per_rad = 80, .drive = DriveTerms::loop};
  const Evaluation e = evaluate(with_loop(bench, 25), &model, options);
  ASSERT_TRUE(e.online);
  EXPECT_NEAR(e.online->k_nm_per_rad, bench.k, 0.03 * bench.k);
  EXPECT_FALSE(e.drive_independent);
  EXPECT_NE(e.drive_from.find("control-loop error"), std::string::npos);
}

TEST(LoopError, TakesTheAngleOnTheMotorsSideWhereThereIsOne) {
  Signals s;
  s.gear_ratio = 100;
  s.module.commanded_angle_rad = {1, 1};
  s.module.input_angle_rad = {0.5, 0.5};
  EXPECT_FALSE(take_loop_error_for_current(s, std::nullopt));
  EXPECT_DOUBLE_EQ(s.module.current_a[0], 0.5);
  s.module.motor_angle_rad = {90, 90};
  EXPECT_FALSE(take_loop_error_for_current(s, 2));
  EXPECT_DOUBLE_EQ(s.module.current_a[0], 0.2);
  s.module.commanded_angle_rad.clear();
  EXPECT_TRUE(take_loop_error_for_current(s, 2));
}

}  // namespace
}  // namespace searig::estimator
