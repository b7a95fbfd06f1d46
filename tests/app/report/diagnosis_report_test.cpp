#include "app/report/diagnosis_report.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "app/report/diagnosis_sentences.h"
#include "app/report/diagnosis_words.h"
#include "tests/app/report/diagnosis_sample.h"

namespace searig::app {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(DiagnosisReport, HoldsEveryPart) {
  const std::string html = diagnosis_report(sample_diagnosis()).text();
  for (const char* part :
       {"Diagnosis of first", "the spring resists being deflected fast", "very likely (93 %)",
        "How likely each explanation is", "Load cell less spring", "enlarged",
        "over the deflection rate", "Where it differs", "before", "after", "Errors", "Numbers",
        "How well each number is known", "What remains unexplained", "A knock",
        "What this recording cannot decide", "Next experiment", "[spring.viscous]"}) {
    EXPECT_TRUE(has(html, part)) << part;
  }
}

TEST(DiagnosisReport, NeedsNothingOutside) {
  const std::string html = diagnosis_report(sample_diagnosis()).text();
  for (const char* outside : {"https:", "src=", "<link", "@import", "<script"}) {
    EXPECT_FALSE(has(html, outside)) << outside;
  }
  EXPECT_FALSE(has(html, "nan"));
}

TEST(DiagnosisReport, HoldsTheModelAsItCameAgainstTheRefittedOneWhereOnlyNumbersAreOff) {
  Examined examined = sample_diagnosis();
  examined.diagnosis.verdict = estimator::Verdict::recalibrate;
  examined.diagnosis.findings.clear();
  examined.diagnosis.unexplained.reset();
  const std::string html = diagnosis_report(examined).text();
  EXPECT_TRUE(has(html, "numbers as the model had them"));
  EXPECT_TRUE(has(html, "from 0.21 to 0.010 N·m"));
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

TEST(DiagnosisReport, DrawsNoSpringWhereThereIsNone) {
  Examined examined = sample_diagnosis();
  auto& d = examined.diagnosis;
  d.drive = std::exchange(d.spring, {});
  d.traces.drive_before_nm = d.traces.spring_before_nm;
  d.traces.drive_after_nm = d.traces.spring_after_nm;
  EXPECT_FALSE(has(diagnosis_report(examined).text(), "Load cell less spring, part by part"));
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

}  // namespace
}  // namespace searig::app
