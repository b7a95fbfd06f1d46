#include "app/report/diagnosis_json.h"

#include <gtest/gtest.h>

#include "tests/app/report/diagnosis_sample.h"

namespace searig::app {
namespace {

TEST(DiagnosisJson, IsAsTheContractHasIt) {
  const Examined examined = sample_diagnosis();
  const auto json = to_json(examined.diagnosis, examined.given);
  EXPECT_EQ(json.at("verdict"), "missing_physics");
  const auto& finding = json.at("findings").at(0);
  EXPECT_EQ(finding.at("effect"), "spring.viscous");
  EXPECT_EQ(finding.at("probability"), 0.93);
  EXPECT_EQ(finding.at("parameters").at(0),
            (nlohmann::json{{"name", "c_nm_s_per_rad"}, {"value", 0.45}, {"ci95", {0.43, 0.47}}}));
  EXPECT_EQ(finding.at("located").at("residuals").at(0), "loadcell-spring");
  EXPECT_EQ(finding.at("located").at("intervals_s").at(0), (nlohmann::json{102.0, 104.0}));
  EXPECT_EQ(finding.at("located").at("regions").at(0).at("channel"), "deflection_rate_rad_s");
  EXPECT_EQ(finding.at("heldout_rmse_nm"), (nlohmann::json{{"before", 0.06}, {"after", 0.01}}));
  EXPECT_EQ(json.at("paths").at("spring").at("heldout_rmse_nm").at("as_given"), 0.21);
  EXPECT_EQ(json.at("paths").at("spring").at("noise_floor_nm"), 0.009);
  EXPECT_FALSE(json.at("paths").contains("drive"));
  EXPECT_EQ(json.at("unexplained").at("p_value"), 0.001);
  EXPECT_EQ(json.at("undecidable").at(0).at("effects").at(0), "spring.cubic");
}

TEST(DiagnosisJson, KeepsWhatHasNoNameOutOfTheAlternatives) {
  const Examined examined = sample_diagnosis();
  const auto finding = to_json(examined.diagnosis, examined.given).at("findings").at(0);
  ASSERT_EQ(finding.at("alternatives").size(), 1u);
  EXPECT_EQ(finding.at("alternatives").at(0).at("effect"), "rig.delay");
  EXPECT_EQ(finding.at("unnamed_probability"), 0.02);
}

TEST(DiagnosisJson, SaysNothingWhereThereIsNothing) {
  const auto json = to_json(estimator::Diagnosis{}, std::nullopt);
  EXPECT_EQ(json.at("verdict"), "consistent");
  EXPECT_TRUE(json.at("unexplained").is_null());
  EXPECT_TRUE(json.at("findings").empty());
  EXPECT_TRUE(json.at("paths").is_object());
}

}  // namespace
}  // namespace searig::app
