#include "estimator/diagnosis/search/refine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "estimator/diagnosis/diagnosis.h"
#include "tests/estimator/diagnosis/simulated_actuator.h"

namespace searig::estimator {
namespace {

TEST(LoudestRun, IsTheRunThatIsLouderThanTheRest) {
  std::vector<double> squares(40, 10.0), counts(40, 10.0);
  for (int i = 17; i <= 22; ++i) squares[std::size_t(i)] = 60.0;
  EXPECT_EQ(loudest_run(squares, counts), (std::pair<std::size_t, std::size_t>{17, 22}));
}

TEST(LoudestRun, IsEverythingWhereNothingIsLouder) {
  const std::vector<double> squares(40, 10.0), counts(40, 10.0);
  EXPECT_EQ(loudest_run(squares, counts), (std::pair<std::size_t, std::size_t>{0, 39}));
}

const SimulatedActuator rig;

/// Where the diagnosis puts what has no name; nothing unless it says so.
std::vector<std::pair<double, double>> place_of(const Signals& signals) {
  const Diagnosis d = diagnose(signals, rig.paper());
  EXPECT_TRUE(d.findings.empty());
  return d.unexplained ? d.unexplained->located.intervals_s
                       : std::vector<std::pair<double, double>>{};
}

void expect_place(const Signals& signals, double from_s, double to_s, double within_s) {
  const auto place = place_of(signals);
  ASSERT_EQ(place.size(), 1u);
  EXPECT_NEAR(place[0].first, from_s, within_s);
  EXPECT_NEAR(place[0].second, to_s, within_s);
}

TEST(Place, OfALoadCellThatReadsTooLittleForAWhile) {
  Signals s = rig.record();
  for (std::size_t i = 0; i < s.loadcell.t_s.size(); ++i)
    if (s.loadcell.t_s[i] > 11.3 && s.loadcell.t_s[i] < 18.9) s.loadcell.torque_nm[i] *= 0.9;
  expect_place(s, 11.3, 18.9, 0.4);
}

/// Noise that is learnt with the while inside has a long memory, under which nothing slow stands
/// out.
TEST(Place, OfDryFrictionThatComesAndGoes) {
  Signals s = rig.record();
  for (std::size_t i = 0; i < s.module.t_s.size(); ++i) {
    const double t = s.module.t_s[i];
    const double w = SimulatedActuator::deflection(t).rate + SimulatedActuator::output(t).rate;
    if (t > 10.3 && t < 15.9) s.module.current_a[i] += 0.02 / rig.gain * std::tanh(w / 0.01);
  }
  expect_place(s, 10.3, 15.9, 0.2);
}

TEST(Place, OfAZeroThatJumpsForGood) {
  Signals s = rig.record();
  for (std::size_t i = 0; i < s.loadcell.t_s.size(); ++i)
    if (s.loadcell.t_s[i] > 14.2) s.loadcell.torque_nm[i] += 0.3;
  const auto place = place_of(s);
  ASSERT_EQ(place.size(), 1u);
  EXPECT_NEAR(0.5 * (place[0].first + place[0].second), 14.2, 0.2);
  EXPECT_NEAR(place[0].second - place[0].first, 1.0, 1e-9);
}

}  // namespace
}  // namespace searig::estimator
