// Telemetry that comes in pieces gives what the whole gives, to the bit.
#include "estimator/evaluation/telemetry.h"

#include <gtest/gtest.h>

#include <random>

#include "estimator/evaluation/evaluation.h"
#include "tests/estimator/evaluation/bench_top.h"

namespace searig::estimator {
namespace {

/// Pieces of uneven size, some of a single row.
class InPieces : public Telemetry {
 public:
  explicit InPieces(const ModuleSignals& module) : module_(module) {}

  void go_through(double context_s, const Take& take) const override {
    BlockMaker blocks(context_s, take);
    std::mt19937 random(3);
    for (std::size_t from = 0; from < module_.t_s.size();) {
      const std::size_t size = random() % 4 == 0 ? 1 : 1 + random() % 300;
      const std::size_t to = std::min(from + size, module_.t_s.size());
      ModuleSignals piece;
      for (const auto column : {&ModuleSignals::t_s, &ModuleSignals::deflection_rad,
                                &ModuleSignals::input_angle_rad, &ModuleSignals::output_angle_rad,
                                &ModuleSignals::current_a, &ModuleSignals::commanded_angle_rad}) {
        const auto& all = module_.*column;
        if (!all.empty()) (piece.*column).assign(all.begin() + long(from), all.begin() + long(to));
      }
      blocks.add(piece);
      from = to;
    }
    blocks.finish();
  }

 private:
  const ModuleSignals& module_;
};

Signals noisy(double seconds) {
  Signals signals = BenchTop{}.record(seconds);
  std::mt19937 random(7);
  std::normal_distribution<double> noise;
  auto& m = signals.module;
  for (std::size_t i = 0; i < m.t_s.size(); ++i) {
    m.t_s[i] += 2e-4 * noise(random) / 3;
    m.deflection_rad[i] += 1e-5 * noise(random);
    m.input_angle_rad[i] += 1e-5 * noise(random);
    m.current_a[i] += 0.01 * noise(random);
    m.commanded_angle_rad.push_back(m.input_angle_rad[i] + 0.02 * m.current_a[i]);
  }
  for (double& torque : signals.loadcell.torque_nm) torque += 0.01 * noise(random);
  return signals;
}

void expect_same(const Score& a, const Score& b) {
  EXPECT_EQ(a.error_percent, b.error_percent);
  EXPECT_EQ(a.rmse_nm, b.rmse_nm);
}

void expect_same(const Evaluation& a, const Evaluation& b) {
  EXPECT_EQ(a.seconds, b.seconds);
  EXPECT_EQ(a.notes, b.notes);
  EXPECT_EQ(a.drive_from, b.drive_from);
  ASSERT_EQ(a.best_fit.has_value(), b.best_fit.has_value());
  ASSERT_EQ(a.online.has_value(), b.online.has_value());
  ASSERT_EQ(a.current.has_value(), b.current.has_value());
  if (a.best_fit) {
    EXPECT_EQ(a.best_fit->k_nm_per_rad, b.best_fit->k_nm_per_rad);
    expect_same(a.best_fit->score, b.best_fit->score);
  }
  if (a.online) {
    EXPECT_EQ(a.online->k_nm_per_rad, b.online->k_nm_per_rad);
    EXPECT_EQ(a.online->trust_weight_s, b.online->trust_weight_s);
    ASSERT_EQ(a.online->convergence.has_value(), b.online->convergence.has_value());
    if (a.online->convergence) {
      EXPECT_EQ(a.online->convergence->after_s, b.online->convergence->after_s);
    }
    expect_same(a.online->score, b.online->score);
  }
  if (a.current) {
    EXPECT_EQ(a.current->gain_nm_per_a, b.current->gain_nm_per_a);
    expect_same(a.current->score, b.current->score);
  }
}

void expect_same_in_pieces(const Signals& signals, const Model* model,
                           const EvaluationOptions& options = {}) {
  const InPieces pieces(signals.module);
  ASSERT_EQ(needs_whole(model, options), "");
  expect_same(evaluate(signals, model, options),
              evaluate(pieces, signals.loadcell, signals.gear_ratio, model, options));
}

TEST(TelemetryInPieces, GivesTheSameWithAFittedGain) {
  expect_same_in_pieces(noisy(30), nullptr, {.initial_k_nm_per_rad = 400});
}

TEST(TelemetryInPieces, GivesTheSameWithAModel) {
  Model model = BenchTop{}.model();
  model.terms.push_back({"drive.inertia", {{"j_kg_m2", 0.01}}});
  model.terms.push_back({"drive.load_friction", {{"share", 0.05}, {"backdriving_ratio", 1.0}}});
  expect_same_in_pieces(noisy(30), &model);
  model.terms.push_back({"spring.relaxation", {{"k1_nm_per_rad", 3}, {"tau_s", 2}}});
  EXPECT_NE(needs_whole(&model, {}), "");
}

TEST(TelemetryInPieces, GivesTheSameByTheControlLoopsError) {
  expect_same_in_pieces(noisy(20), nullptr, {.drive = DriveTerms::loop});
}

TEST(TelemetryInPieces, GivesTheSameWhereItIsSparseHasGapsAndEndsEarly) {
  Signals signals = noisy(30);
  ModuleSignals& m = signals.module;
  for (auto* column : {&m.t_s, &m.deflection_rad, &m.input_angle_rad, &m.output_angle_rad,
                       &m.current_a, &m.commanded_angle_rad}) {
    column->erase(column->begin() + 4000, column->begin() + 6000);
    column->resize(column->size() - 900);
    std::vector<double> kept;
    for (std::size_t i = 0; i < column->size(); ++i)
      if (i < 3000 || i % 40 == 0) kept.push_back((*column)[i]);
    *column = kept;
  }
  signals.loadcell.torque_nm[100] = NAN;
  expect_same_in_pieces(signals, nullptr);
  const Model model = BenchTop{}.model();
  expect_same_in_pieces(signals, &model);
}

TEST(WatchedEvaluation, GivesTheTrackInStretchesAndNothingElseIsDifferent) {
  const Signals signals = noisy(300);  // 150,000 rows
  const Model model = BenchTop{}.model();
  const EvaluationOptions options{.initial_k_nm_per_rad = 400};
  const Evaluation whole = evaluate(signals, &model, options);
  std::vector<OnlineEstimate> track;
  std::size_t stretches = 0;
  const Evaluation watched =
      evaluate(signals, &model, options, {.track = [&](std::span<const OnlineEstimate> more) {
                 track.insert(track.end(), more.begin(), more.end());
                 ++stretches;
               }});
  expect_same(whole, watched);
  EXPECT_GE(stretches, 3u);
  EXPECT_TRUE(watched.online->track.empty());
  ASSERT_EQ(track.size(), whole.online->track.size());
  for (std::size_t i = 0; i < track.size(); ++i)
    ASSERT_EQ(track[i].k_nm_per_rad, whole.online->track[i].k_nm_per_rad) << i;
}

TEST(WatchedEvaluation, EndsWhenTheWatchThrows) {
  const Signals signals = noisy(300);
  int seen = 0;
  const Watch watch{.track = [&](auto) {
    if (++seen == 2) throw std::runtime_error("enough");
  }};
  EXPECT_THROW(evaluate(signals, nullptr, {}, watch), std::runtime_error);
  EXPECT_EQ(seen, 2);
}

TEST(TelemetryInPieces, HasEachRowOnceWithWhatLiesAroundIt) {
  const Signals signals = noisy(10);
  const InPieces pieces(signals.module);
  std::vector<double> seen;
  pieces.go_through(0.02, [&](const TelemetryBlock& block) {
    const auto& t = block.rows.t_s;
    for (std::size_t i = block.from; i < block.to; ++i) seen.push_back(t[i]);
    if (block.from < block.to && seen.front() != t[block.from]) {
      EXPECT_LT(t.front(), t[block.from] - 0.02 + 0.0025);
    }
  });
  EXPECT_EQ(seen, signals.module.t_s);
}

}  // namespace
}  // namespace searig::estimator
