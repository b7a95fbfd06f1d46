#include "app/reproduce/reproduction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/reproduce/figure.h"
#include "estimator/model/predict.h"

namespace searig::app::reproduce {
namespace {

Settings small() {
  Settings settings;
  settings.seeds = 2;
  settings.protocol.seconds = 30.0;
  return settings;
}

TEST(Reproduction, ComesOutTheSameOnOneThreadAndOnTwo) {
  Settings one = small(), two = small();
  one.jobs = 1, two.jobs = 2;
  double last = 0;
  const auto a = reproduce(one, [&](double share) { last = share; });
  const auto b = reproduce(two, [](double) {});
  EXPECT_EQ(last, 1.0);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(a.trials[i].best_fit_k_nm_per_rad, b.trials[i].best_fit_k_nm_per_rad);
    EXPECT_EQ(a.trials[i].online[0].last_k_nm_per_rad, b.trials[i].online[0].last_k_nm_per_rad);
    EXPECT_EQ(a.trials[i].seed, i + 1);
  }
  EXPECT_NE(a.trials[0].best_fit_k_nm_per_rad, a.trials[1].best_fit_k_nm_per_rad);
  EXPECT_NE(a.trials[0].current.error_percent, a.dragged[0].current.error_percent);
}

/// A trial whose numbers can be told by hand.
TrialFigures trial(double fit, double current, double online, std::optional<double> off) {
  TrialFigures out;
  out.best_fit_k_nm_per_rad = 40;
  out.best_fit.error_percent = fit;
  out.current.error_percent = current;
  OnlineFigures figures;
  figures.good.error_percent = online;
  if (off) figures.approach = Approach{.after_s = 10, .off_percent = *off};
  out.online = {figures};
  return out;
}

TEST(Targets, AreMeansWithTheTrialsThatHoldByThemselves) {
  const std::vector<TrialFigures> trials = {trial(8, 24, 8, -4.0), trial(8, 24, 10, 9.0),
                                            trial(8, 12, 9, std::nullopt)};
  const Targets t = targets(trials, 0);
  EXPECT_DOUBLE_EQ(t.over_best_fit, 27.0 / 24.0);
  EXPECT_EQ(t.within_best_fit, 2);
  EXPECT_DOUBLE_EQ(t.over_current, 27.0 / 60.0);
  EXPECT_EQ(t.within_current, 2);
  EXPECT_EQ(t.reached, 2);
  EXPECT_EQ(t.close, 1);
  EXPECT_DOUBLE_EQ(t.worst_off_percent, 9.0);
  EXPECT_DOUBLE_EQ(t.mean_off_percent, 2.5);
}

// The other trials' stiffness on this one: |39 - 40| and |41 - 40| of 40.
TEST(Table1, TheOthersStiffnessLeavesTheTrialItselfOut) {
  Reproduction all;
  all.variants.resize(1);
  for (const double k : {40.0, 41.0}) {
    TrialFigures figures = trial(8, 24, 8, std::nullopt);
    figures.best_fit_k_nm_per_rad = k;
    figures.deflection_rad = {0.1, -0.1};
    figures.measured_nm = {0.1 * k, -0.1 * k};
    all.trials.push_back(figures);
  }
  const auto rows = table_1(all, all.trials);
  EXPECT_EQ(rows.back().key, "others_stiffness");
  EXPECT_NEAR(rows.back().trials[0], 100.0 * 1 / 40, 1e-9);
  EXPECT_NEAR(rows.back().trials[1], 100.0 * 1 / 41, 1e-9);
  EXPECT_EQ(rows.front().paper, 7.0);
}

// eta is measured at one load; a line through two loads finds the share of the teeth.
TEST(Variants, KnowTheDriveFromTheBenchAlone) {
  const auto all = variants(Protocol{});
  ASSERT_EQ(all.size(), 4u);
  const double eta = *all[0].drive.get("drive.motor", "efficiency");
  EXPECT_GT(eta, 0.75);
  EXPECT_LT(eta, 0.82);
  EXPECT_TRUE(all[0].exactly_as_the_paper);
  EXPECT_FALSE(all[0].drive.has("drive.coulomb"));
  EXPECT_NEAR(*all[2].drive.get("drive.motor", "efficiency"), 1.0 / 1.12, 0.005);
  EXPECT_NEAR(*all[2].drive.get("drive.coulomb", "torque_nm"), 0.445 / 1.12, 0.01);
  EXPECT_EQ(all[3].drive.get("drive.coulomb", "torque_nm"),
            all[2].drive.get("drive.coulomb", "torque_nm"));
}

// Rubber that loses work is stiffer while it is loaded, which is when the current is trusted; the
// damping term of equation (12) takes that off the stiffness.
TEST(Variants, WithADampingTermFindTheStiffnessOfLossyRubber) {
  const Protocol protocol;
  const auto trial = run_trial(1, Hand::holds_against, protocol, variants(protocol));
  const auto& online = trial.figures.online;
  ASSERT_TRUE(online[3].approach);
  EXPECT_LT(std::abs(online[3].approach->off_percent), 5.0);
  EXPECT_LT(online[3].good.error_percent, online[2].good.error_percent);
}

TEST(Figures, AreAsLongAsTheirColumnsAndKeepToTheWindow) {
  const auto all = reproduce(small(), [](double) {});
  const auto made = figures(all);
  ASSERT_EQ(made.size(), 9u);
  for (const Figure& figure : made) {
    for (const Column& column : figure.columns) {
      EXPECT_EQ(column.values.size(), figure.columns[0].values.size()) << figure.name;
      for (const double value : column.values) ASSERT_TRUE(std::isfinite(value)) << column.name;
    }
    if (figure.name > "figure_03" && figure.name < "table") {
      EXPECT_EQ(figure.columns[0].name, "t_s");
      EXPECT_NEAR(figure.columns[0].values.back(), 15.0, 0.03) << figure.name;
    }
    EXPECT_FALSE(figure.paper.empty() || figure.ours.empty() || figure.verdict.empty());
    EXPECT_EQ(figure.verdict.find("nan"), std::string::npos);
  }
}

}  // namespace
}  // namespace searig::app::reproduce
