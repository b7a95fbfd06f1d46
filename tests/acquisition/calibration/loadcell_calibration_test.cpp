#include "acquisition/calibration/loadcell_calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "acquisition/error.h"
#include "tests/acquisition/recording/refusal.h"

namespace searig::acquisition {
namespace {

/// Readings of a cell that gives `slope` counts per newton about 84000, with scatter.
std::vector<KnownWeight> readings(std::mt19937_64& random, double slope, double scatter) {
  std::normal_distribution<double> noise(0.0, scatter);
  std::vector<KnownWeight> weights;
  for (const double kg : {0.0, 0.0, 0.5, 1.0, 2.0, 3.0, 5.0})
    weights.push_back({9.81 * kg, 84000.0 + slope * 9.81 * kg + noise(random)});
  return weights;
}

TEST(LoadcellCalibration, FindsAStraightLineExactly) {
  const auto c = calibrate({{0.0, 100.0}, {10.0, 2100.0}, {20.0, 4100.0}});
  EXPECT_DOUBLE_EQ(c.tare_counts, 100.0);
  EXPECT_DOUBLE_EQ(c.newton_per_count, 0.005);
  EXPECT_DOUBLE_EQ(c.force_n(1100.0), 5.0);
  EXPECT_EQ(doubts(c).size(), 1u);  // too good to be measured
}

TEST(LoadcellCalibration, ItsIntervalsHoldTheTruthInNinetyFiveOfAHundred) {
  std::mt19937_64 random(1);
  int tare = 0, gain = 0;
  constexpr int runs = 2000;
  for (int i = 0; i < runs; ++i) {
    const auto c = calibrate(readings(random, -2000.0, 300.0));
    tare += std::abs(c.tare_counts - 84000.0) <= c.tare_ci95_counts;
    gain += std::abs(c.newton_per_count + 1.0 / 2000.0) <= c.newton_per_count_ci95;
    ASSERT_LT(c.newton_per_count, 0.0);  // its polarity
  }
  EXPECT_NEAR(tare / double(runs), 0.95, 0.015);
  EXPECT_NEAR(gain / double(runs), 0.95, 0.015);
}

TEST(LoadcellCalibration, DoubtsAnOutlierAndABend) {
  std::mt19937_64 random(2);
  auto weights = readings(random, 2000.0, 20.0);
  weights.insert(weights.end(), weights.begin(), weights.end());
  EXPECT_TRUE(doubts(calibrate(weights)).empty());
  auto outlier = weights;
  outlier[3].counts += 900.0;
  ASSERT_EQ(doubts(calibrate(outlier)).size(), 1u);
  EXPECT_TRUE(says(doubts(calibrate(outlier))[0], "off the line"));
  for (KnownWeight& w : weights) w.counts += 0.8 * w.force_n * w.force_n;
  bool bent = false;
  for (const auto& doubt : doubts(calibrate(weights))) bent = bent || says(doubt, "bent");
  EXPECT_TRUE(bent);
}

TEST(LoadcellCalibration, RefusesWhatIsNone) {
  EXPECT_TRUE(says(refusal([] { (void)calibrate({{0, 1}, {1, 2}}); }), "three readings"));
  EXPECT_TRUE(says(refusal([] { (void)calibrate({{1, 1}, {1, 2}, {1, 3}}); }), "one force"));
  EXPECT_TRUE(says(refusal([] { (void)calibrate({{0, 7}, {1, 7}, {2, 7}}); }), "do not depend"));
}

TEST(LoadcellCalibration, IsWrittenAndReadExactly) {
  std::mt19937_64 random(3);
  auto c = calibrate(readings(random, 1234.5, 10.0));
  c.lever_arm_m = -0.15;
  c.date = "2026-11-22";
  const std::string toml = to_toml(c);
  const auto read = parse_calibration(toml, "c.toml");
  EXPECT_EQ(to_toml(read), toml);
  EXPECT_EQ(read.newton_per_count, c.newton_per_count);
  EXPECT_EQ(read.lever_arm_m, -0.15);
  EXPECT_TRUE(says(refusal([] { (void)parse_calibration("format = \"x\"", "c.toml"); }),
                   "c.toml: format must be"));
  std::string broken = toml;
  broken.replace(broken.find("newton_per_count = "), 19, "newton_per_cow = ");
  EXPECT_TRUE(says(refusal([&] { (void)parse_calibration(broken, "c.toml"); }),
                   "newton_per_count must be a finite number"));
}

}  // namespace
}  // namespace searig::acquisition
