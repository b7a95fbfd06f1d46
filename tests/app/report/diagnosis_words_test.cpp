#include "app/report/diagnosis_words.h"

#include <gtest/gtest.h>

#include <string>

#include "app/report/diagnosis_sentences.h"
#include "tests/app/report/diagnosis_sample.h"

namespace searig::app {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(DiagnosisWords, AreShortAndCarryTheNumbers) {
  const Examined examined = sample_diagnosis();
  const auto lines = sentences(examined.diagnosis, examined.given);
  ASSERT_FALSE(lines.empty());
  EXPECT_TRUE(has(lines.front(), "falls from 0.060 to 0.010 N·m"));
  std::string all;
  for (const auto& line : lines) all += line + "\n";
  for (const char* part :
       {"c = 0.450 N·m·s/rad (95 %: 0.430 to 0.470)", "deflection rate 0.10 to 0.90 rad/s",
        "a sharp knock on the lever", "something without a name", "the model had 42.0",
        "larger deflections", "Next experiment: The same motion"}) {
    EXPECT_TRUE(has(all, part)) << part << "\n" << all;
  }
}

TEST(DiagnosisWords, CountARipplesWavesPerTurnOfTheMotor) {
  estimator::Finding ripple;
  ripple.effect = "drive.ripple";
  ripple.parameters = {{"drive.ripple", "cycles_per_rad", 378.0, 377.0, 379.0},
                       {"drive.ripple", "cycles2_per_rad", 189.0, 188.0, 190.0}};
  EXPECT_TRUE(has(waves_per_turn(ripple, 9.0), "There are 42.0 and 21.0 waves"));
  EXPECT_EQ(waves_per_turn(ripple, 1.0), "");
  EXPECT_EQ(waves_per_turn({}, 9.0), "");
}

TEST(DiagnosisWords, NeverSayThatSomethingIsCertain) {
  EXPECT_EQ(how_sure(0.9999), "almost certain (over 99 %)");
  EXPECT_EQ(how_sure(0.72), "likely (72 %)");
}

TEST(DiagnosisWords, JoinNeighbouringRegions) {
  estimator::Located located;
  located.regions = {{"deflection_rad", -0.20, -0.10},
                     {"deflection_rad", -0.09, 0.05},
                     {"deflection_rad", 0.15, 0.20}};
  EXPECT_EQ(where(located), "deflection −0.20 to 0.050 and 0.15 to 0.20 rad");
  EXPECT_EQ(where({}), "");
}

TEST(DiagnosisWords, CallNoNumberOffThatTheMeasurementAllows) {
  estimator::Diagnosis d;
  d.verdict = estimator::Verdict::missing_physics;
  d.numbers = {{"spring.linear", "k_nm_per_rad", 40.0, 39.9, 40.1}};
  estimator::Model given;
  given.set("spring.linear", "k_nm_per_rad", 40.3);  // not a percent away
  EXPECT_TRUE(moved_numbers(d, given).empty());
  given.set("spring.linear", "k_nm_per_rad", 42.0);
  EXPECT_EQ(moved_numbers(d, given).size(), 1u);
}

TEST(DiagnosisWords, SpeakOfThePathThatIsThere) {
  estimator::Diagnosis d;
  EXPECT_EQ(clearest(d), nullptr);
  d.drive = estimator::PathErrors{std::nullopt, 0.01, 0.05, 0.009};  // it got worse, fivefold
  EXPECT_EQ(clearest(d), &*d.drive);
  d.spring = estimator::PathErrors{std::nullopt, 0.06, 0.01, 0.009};
  EXPECT_EQ(clearest(d), &*d.spring);
}

TEST(DiagnosisWords, KeepTheNumbersOfOneEffectTogether) {
  std::string order;
  for (const auto& p : in_order({{"drive.motor", "torque_constant_nm_per_a", 1, 1, 1},
                                 {"rig.delay", "delay_s", 1, 1, 1},
                                 {"drive.motor", "efficiency", 1, 1, 1}}))
    order += p.name + " ";
  EXPECT_TRUE(order == "torque_constant_nm_per_a efficiency delay_s " ||
              order == "efficiency torque_constant_nm_per_a delay_s ")
      << order;
}

}  // namespace
}  // namespace searig::app
