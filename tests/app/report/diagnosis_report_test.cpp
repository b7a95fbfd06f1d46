#include "app/report/diagnosis_report.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

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

TEST(DiagnosisReport, DrawsNoSpringWhereThereIsNone) {
  Examined examined = sample_diagnosis();
  auto& d = examined.diagnosis;
  d.drive = std::exchange(d.spring, {});
  d.traces.drive_before_nm = d.traces.spring_before_nm;
  d.traces.drive_after_nm = d.traces.spring_after_nm;
  EXPECT_FALSE(has(diagnosis_report(examined).text(), "Load cell less spring, part by part"));
}

}  // namespace
}  // namespace searig::app
