#include "estimator/diagnosis/diagnosis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "tests/estimator/diagnosis/simulated_actuator.h"

namespace searig::estimator {
namespace {

std::set<std::string> names(const Diagnosis& d) {
  std::set<std::string> out;
  for (const auto& f : d.findings) out.insert(f.effect);
  return out;
}

/// Asserts that this effect alone is missing, with the parameter within `share` of the truth.
void expect_found(const SimulatedActuator& rig, const std::string& effect,
                  const std::string& parameter, double truth, double share) {
  const Diagnosis d = diagnose(rig.record(), rig.paper());
  EXPECT_EQ(d.verdict, Verdict::missing_physics);
  ASSERT_EQ(names(d), std::set<std::string>{effect});
  const Finding& f = d.findings.front();
  EXPECT_GT(f.probability, 0.5);
  EXPECT_LT(f.after_nm, f.before_nm);
  const auto value = d.extended.get(effect, parameter);
  ASSERT_TRUE(value) << "the extended model lacks " << effect << " " << parameter;
  EXPECT_NEAR(*value, truth, share * std::abs(truth));
  bool told = false;
  for (const auto& p : f.parameters) told = told || (p.name == parameter && p.value == *value);
  EXPECT_TRUE(told);
}

TEST(Diagnose, FindsNothingWhereNothingIsMissing) {
  for (const double memory : {0.0, 0.9}) {
    SimulatedActuator rig;
    rig.memory = memory;
    const Diagnosis d = diagnose(rig.record(), rig.paper());
    EXPECT_EQ(d.verdict, Verdict::consistent) << "memory " << memory;
    EXPECT_TRUE(d.findings.empty()) << d.findings.front().effect << ", memory " << memory;
    EXPECT_FALSE(d.unexplained) << "memory " << memory;
    ASSERT_TRUE(d.spring && d.drive);
    EXPECT_NEAR(d.spring->after, rig.noise_nm, 0.2 * rig.noise_nm);
  }
}

/// Straight lines between slow samples of the telemetry are no physics, however quiet the load
/// cell.
TEST(Diagnose, FindsNothingWhereTheTelemetryIsSlowerThanTheLoadCell) {
  SimulatedActuator rig;
  rig.module_step_s = 0.025, rig.loadcell_step_s = 0.005, rig.noise_nm = 0.003;
  const Diagnosis d = diagnose(rig.record(), rig.paper());
  EXPECT_TRUE(d.findings.empty()) << d.findings.front().effect;
  EXPECT_FALSE(d.unexplained) << d.unexplained->what;
}

TEST(Diagnose, AsksForOtherNumbersWhereOnlyTheStiffnessIsWrong) {
  SimulatedActuator rig;
  Model wrong = rig.paper();
  wrong.set("spring.linear", "k_nm_per_rad", 1.3 * rig.k);
  const Diagnosis d = diagnose(rig.record(), wrong);
  EXPECT_EQ(d.verdict, Verdict::recalibrate);
  EXPECT_TRUE(d.findings.empty());
  EXPECT_NEAR(*d.extended.get("spring.linear", "k_nm_per_rad"), rig.k, 0.005 * rig.k);
  ASSERT_TRUE(d.spring && d.spring->as_given);
  EXPECT_GT(*d.spring->as_given, 5 * d.spring->before);
}

TEST(Diagnose, JudgesAModelAsGivenWithTheDelayThatItWasGiven) {
  const SimulatedActuator rig;
  Model late = rig.paper();
  late.set("rig.delay", "delay_s", 0.05);
  const Diagnosis d = diagnose(rig.record(), late);
  ASSERT_TRUE(d.spring && d.spring->as_given);
  EXPECT_GT(*d.spring->as_given, 5 * d.spring->before);
}

TEST(Diagnose, NamesAMissingDamper) {
  SimulatedActuator rig;
  rig.viscous = 0.6;
  expect_found(rig, "spring.viscous", "c_nm_s_per_rad", 0.6, 0.05);
}

TEST(Diagnose, NamesAMissingDamperUnderNoiseWithMemory) {
  SimulatedActuator rig;
  rig.viscous = 0.6;
  rig.memory = 0.9;
  expect_found(rig, "spring.viscous", "c_nm_s_per_rad", 0.6, 0.08);
}

TEST(Diagnose, NamesAMissingCubicStiffness) {
  SimulatedActuator rig;
  rig.cubic = 120;
  expect_found(rig, "spring.cubic", "k3_nm_per_rad3", 120, 0.05);
}

TEST(Diagnose, NamesMissingFrictionInTheDrive) {
  SimulatedActuator rig;
  rig.coulomb = 0.4;
  expect_found(rig, "drive.coulomb", "torque_nm", 0.4, 0.05);
}

/// The lever swings by less than half a radian: a weight that hangs down shows, one that stands out
/// sideways pulls almost evenly.
TEST(Diagnose, SaysThatAWeightMayHangWhereItCannotBeSeen) {
  const SimulatedActuator rig;
  const Diagnosis d = diagnose(rig.record(), rig.paper());
  const auto weight = std::ranges::find(d.undecidable, std::vector<std::string>{"rig.gravity"},
                                        &Undecidable::effects);
  ASSERT_NE(weight, d.undecidable.end());
  EXPECT_NE(weight->why.find("at its least visible phase"), std::string::npos) << weight->why;
}

/// A nameless function of the current would take back the current's noise while the torque constant
/// grew, and push the friction out.
TEST(Diagnose, NamesFrictionUnderOneSineAndANoisyCurrent) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    SimulatedActuator rig;
    rig.one_sine = true, rig.coulomb = 0.2, rig.noise_a = 0.1, rig.seed = seed;
    const Diagnosis d = diagnose(rig.record(), rig.paper());
    EXPECT_EQ(names(d), std::set<std::string>{"drive.coulomb"}) << "seed " << seed;
    EXPECT_FALSE(d.unexplained) << d.unexplained->what << ", seed " << seed;
  }
}

TEST(Diagnose, FindsTheNumbersOfThePapersEquationsWithoutAModel) {
  const SimulatedActuator rig;
  const Diagnosis d = diagnose(rig.record(), std::nullopt);
  EXPECT_EQ(d.verdict, Verdict::recalibrate);
  EXPECT_NEAR(*d.extended.get("spring.linear", "k_nm_per_rad"), rig.k, 0.005 * rig.k);
  EXPECT_NEAR(*d.extended.get("drive.motor", "torque_constant_nm_per_a") *
                  *d.extended.get("drive.motor", "efficiency"),
              rig.gain, 0.01 * rig.gain);
  EXPECT_FALSE(d.spring->as_given);
}

TEST(Diagnose, GivesTheSameAnswerTwice) {
  SimulatedActuator rig;
  rig.cubic = 120;
  const auto signals = rig.record();
  const Diagnosis one = diagnose(signals, rig.paper()), two = diagnose(signals, rig.paper());
  EXPECT_EQ(to_toml(one.extended), to_toml(two.extended));
  ASSERT_EQ(one.findings.size(), two.findings.size());
  for (std::size_t i = 0; i < one.findings.size(); ++i) {
    EXPECT_EQ(one.findings[i].probability, two.findings[i].probability);
    EXPECT_EQ(one.findings[i].located.share, two.findings[i].located.share);
  }
}

TEST(Diagnose, LooksAtTheSpringAloneWhereThereIsNoCurrent) {
  SimulatedActuator rig;
  Signals s = rig.record();
  s.module.current_a.clear();
  const Diagnosis d = diagnose(s, rig.paper());
  EXPECT_TRUE(d.spring);
  EXPECT_FALSE(d.drive);
  EXPECT_TRUE(d.findings.empty());
  EXPECT_FALSE(d.notes.empty());
}

/// Two recordings one behind the other, the load cell tared differently in the second.
Signals tared_twice(const SimulatedActuator& rig, double zero_nm) {
  Signals s = rig.record();
  const Signals second = rig.record();
  const double begins = rig.seconds + 20.0;
  for (const double t : second.module.t_s) s.module.t_s.push_back(t + begins);
  for (const double t : second.loadcell.t_s) s.loadcell.t_s.push_back(t + begins);
  for (const double x : second.loadcell.torque_nm) s.loadcell.torque_nm.push_back(x + zero_nm);
  const auto append = [](std::vector<double>& to, const std::vector<double>& x) {
    to.insert(to.end(), x.begin(), x.end());
  };
  append(s.module.deflection_rad, second.module.deflection_rad);
  append(s.module.input_angle_rad, second.module.input_angle_rad);
  append(s.module.output_angle_rad, second.module.output_angle_rad);
  append(s.module.current_a, second.module.current_a);
  s.part_starts_s = {0.0, begins};
  return s;
}

TEST(Diagnose, TakesTwoZerosOfTwoRecordingsForNoDrift) {
  const SimulatedActuator rig;
  const Diagnosis d = diagnose(tared_twice(rig, 0.4), rig.paper());
  EXPECT_TRUE(d.findings.empty()) << d.findings.front().effect;
  EXPECT_FALSE(d.unexplained) << d.unexplained->what;
  EXPECT_NEAR(d.spring->after, rig.noise_nm, 0.2 * rig.noise_nm);
}

TEST(Diagnose, SeesTheZeroJumpWhereItIsOneRecording) {
  const SimulatedActuator rig;
  Signals s = tared_twice(rig, 0.4);
  s.part_starts_s.clear();
  const Diagnosis d = diagnose(s, rig.paper());
  EXPECT_TRUE(d.unexplained || !d.findings.empty());
}

TEST(Diagnose, SaysThatARecordingIsTooShortAndStopsWhenTold) {
  SimulatedActuator rig;
  rig.seconds = 1;
  EXPECT_THROW(diagnose(rig.record(), rig.paper()), std::invalid_argument);
  rig.seconds = 20;
  const auto stop = [](const std::string&, double) { return false; };
  EXPECT_THROW(diagnose(rig.record(), rig.paper(), stop), std::runtime_error);
}

}  // namespace
}  // namespace searig::estimator
