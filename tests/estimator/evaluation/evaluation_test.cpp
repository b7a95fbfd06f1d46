#include "estimator/evaluation/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/estimator/evaluation/bench_top.h"

namespace searig::estimator {
namespace {

bool says(const std::vector<std::string>& notes, const std::string& part) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

TEST(Evaluate, BestFitIsSlopeAndOffset) {
  const BenchTop bench{.loadcell_offset = 0.25};
  const Evaluation result = evaluate(bench.record(10));
  ASSERT_TRUE(result.best_fit);
  EXPECT_NEAR(result.best_fit->k_nm_per_rad, 40, 0.002);
  EXPECT_NEAR(result.best_fit->offset_nm, 0.25, 1e-4);
  EXPECT_LT(result.best_fit->score.error_percent, 0.02);
  EXPECT_NEAR(result.seconds, 10, 0.01);
}

TEST(Evaluate, OnlineFindsTheStiffnessFromTenTimesTooHighAndTooLow) {
  const BenchTop bench;
  const Model model = bench.model();
  for (const double factor : {0.1, 1.0, 10.0}) {
    const Evaluation result =
        evaluate(bench.record(30), &model, {.initial_k_nm_per_rad = factor * 40});
    ASSERT_TRUE(result.online);
    EXPECT_EQ(result.online->initial_k_nm_per_rad, factor * 40);
    EXPECT_NEAR(result.online->k_nm_per_rad, 40, 0.4) << factor;
    ASSERT_TRUE(result.online->convergence) << factor;
    EXPECT_LT(result.online->convergence->after_s, 10) << factor;
    EXPECT_LE(result.online->convergence->trust_weight_s, result.online->trust_weight_s);
    EXPECT_TRUE(result.drive_independent);
  }
}

// The score of the online estimate is that of k theta with the k of that moment, not the last k.
TEST(Evaluate, OnlineErrorHasTheWayThereInIt) {
  const BenchTop bench;
  const Model model = bench.model();
  const auto good = evaluate(bench.record(30), &model, {.initial_k_nm_per_rad = 40});
  const auto poor = evaluate(bench.record(30), &model, {.initial_k_nm_per_rad = 400});
  EXPECT_LT(good.online->score.error_percent, 0.5);
  EXPECT_GT(poor.online->score.error_percent, 1.0);
}

// Friction that the drive model lacks is torque that the current claims to have delivered.
TEST(Evaluate, PapersEquationTwoReadsFrictionAsTorque) {
  const BenchTop bench;
  const Model model = bench.model();
  const Evaluation all = evaluate(bench.record(30), &model);
  const Evaluation paper = evaluate(bench.record(30), &model, {.drive = DriveTerms::paper});
  EXPECT_LT(all.current->score.error_percent, 0.5);
  EXPECT_GT(paper.current->score.error_percent, 10);
  EXPECT_GT(paper.online->k_nm_per_rad, 41);
  EXPECT_NE(all.drive_from.find("drive.coulomb"), std::string::npos);
  EXPECT_EQ(paper.drive_from.find("drive.coulomb"), std::string::npos);
}

TEST(Evaluate, FitsTheWorthOfAnAmpereWhereNoModelTellsAndSaysSo) {
  const BenchTop bench{.loadcell_offset = 0.25, .friction = 0};
  const Evaluation result = evaluate(bench.record(20));
  ASSERT_TRUE(result.current && result.online);
  EXPECT_FALSE(result.drive_independent);
  EXPECT_NE(result.drive_from.find("fitted to the load cell"), std::string::npos);
  EXPECT_NEAR(result.current->gain_nm_per_a, 2, 0.002);
  EXPECT_NEAR(result.current->offset_nm, 0.25, 0.002);
  EXPECT_NEAR(result.online->k_nm_per_rad, 40, 0.4);
}

TEST(Evaluate, StartsFromTheModelElseFromTheBestFit) {
  const BenchTop bench;
  Model model = bench.model();
  model.set("spring.linear", "k_nm_per_rad", 55);
  const Evaluation believed = evaluate(bench.record(10), &model);
  EXPECT_EQ(believed.online->initial_k_nm_per_rad, 55);
  EXPECT_TRUE(says(believed.notes, "the model's stiffness"));
  const Evaluation fitted = evaluate(bench.record(10));
  EXPECT_EQ(fitted.online->initial_k_nm_per_rad, fitted.best_fit->k_nm_per_rad);
  EXPECT_TRUE(says(fitted.notes, "the best fit"));
}

TEST(Evaluate, SwitchesOffWhatHasNoChannel) {
  const BenchTop bench;
  const Model model = bench.model();
  Signals no_spring = bench.record(10);
  no_spring.module.deflection_rad.clear();
  no_spring.module.output_angle_rad.clear();
  const Evaluation current = evaluate(no_spring, &model);
  EXPECT_TRUE(current.current && !current.best_fit && !current.online);
  EXPECT_TRUE(says(current.notes, "no deflection"));

  Signals no_current = bench.record(10);
  no_current.module.current_a.clear();
  const Evaluation fit = evaluate(no_current, &model);
  EXPECT_TRUE(!fit.current && fit.best_fit && !fit.online);
  EXPECT_TRUE(says(fit.notes, "no motor current"));
}

TEST(Evaluate, TakesTheMotorAloneWhereThereIsNoInputAngle) {
  const BenchTop bench{.friction = 0};
  const Model model = bench.model();
  Signals signals = bench.record(10);
  signals.module.input_angle_rad.clear();
  signals.module.output_angle_rad.clear();
  const Evaluation result = evaluate(signals, &model);
  EXPECT_NE(result.drive_from.find("drive.motor alone"), std::string::npos);
  EXPECT_LT(result.current->score.error_percent, 0.1);
}

TEST(Evaluate, ComparesOnlyWhereThereIsTelemetry) {
  const BenchTop bench;
  Signals signals = bench.record(10);
  const double k = evaluate(signals).best_fit->k_nm_per_rad;
  for (const double t : {-1.0, -0.5, 10.5, 11.0}) {
    signals.loadcell.t_s.push_back(t);
    signals.loadcell.torque_nm.push_back(1e6);
  }
  EXPECT_EQ(evaluate(signals).best_fit->k_nm_per_rad, k);
}

// Interpolating over a lost second would compare the load cell with a motion that never was.
TEST(Evaluate, LeavesOutWhatFallsIntoAGap) {
  const BenchTop bench;
  Signals signals = bench.record(10);
  auto& module = signals.module;
  for (auto* channel : {&module.t_s, &module.deflection_rad, &module.input_angle_rad,
                        &module.output_angle_rad, &module.current_a}) {
    channel->erase(channel->begin() + 2000, channel->begin() + 2500);
  }
  const Evaluation result = evaluate(signals);
  EXPECT_NEAR(result.best_fit->k_nm_per_rad, 40, 0.002);
  EXPECT_TRUE(says(result.notes, "50 load-cell samples are left out"));
}

TEST(Evaluate, SaysWhenASignIsWrong) {
  Signals signals = BenchTop().record(10);
  for (double& torque : signals.loadcell.torque_nm) torque = -torque;
  EXPECT_TRUE(says(evaluate(signals).notes, "sign"));
}

TEST(Evaluate, RefusesWhatCannotBeCompared) {
  const BenchTop bench;
  EXPECT_THROW(evaluate(Signals{}), std::invalid_argument);
  Signals no_loadcell = bench.record(10);
  no_loadcell.loadcell = {};
  EXPECT_THROW(evaluate(no_loadcell), std::invalid_argument);
  Signals other_times = bench.record(10);
  for (double& t : other_times.loadcell.t_s) t += 100;
  EXPECT_THROW(evaluate(other_times), std::invalid_argument);
  Signals nothing_to_hold = bench.record(10);
  nothing_to_hold.module.deflection_rad.clear();
  nothing_to_hold.module.current_a.clear();
  EXPECT_THROW(evaluate(nothing_to_hold), std::invalid_argument);
}

TEST(Evaluate, SurvivesASpringAndAMotorThatStandStill) {
  Signals signals = BenchTop().record(10);
  std::fill(signals.module.deflection_rad.begin(), signals.module.deflection_rad.end(), 0.01);
  std::fill(signals.module.current_a.begin(), signals.module.current_a.end(), 0.5);
  const Evaluation result = evaluate(signals);
  EXPECT_TRUE(!result.best_fit && !result.current && !result.online);
  EXPECT_TRUE(says(result.notes, "deflection never changes"));
  EXPECT_TRUE(says(result.notes, "current never changes"));
}

}  // namespace
}  // namespace searig::estimator
