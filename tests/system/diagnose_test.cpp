// searig diagnose, as a user calls it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/system/run_program.h"
#include "tests/temporary_folder.h"

namespace searig {
namespace {

namespace fs = std::filesystem;

/// A recording of a damped spring, held against a model without the damping.
class DiagnoseCommand : public testing::Test {
 protected:
  DiagnoseCommand() {
    folder_.write("spec.toml", R"(format = "searig-spec/1"
[model.spring.linear]
k_nm_per_rad = 40.0
[model.spring.viscous]
c_nm_s_per_rad = 0.5
[model.drive.motor]
torque_constant_nm_per_a = 2.6
efficiency = 0.75
[motion]
seconds = 30.0
amplitudes_rad = [0.05, 0.2]
frequencies_hz = [0.3, 1.0]
output_rad = 0.3
[rates]
module_hz = 200.0
[noise]
loadcell_nm = 0.01
current_a = 0.01
)");
    EXPECT_EQ(
        run_program("searig simulate " + path("spec.toml") + " --out " + path("made")).exit_code,
        0);
    folder_.write("believed.toml", R"(format = "searig-model/1"
[spring.linear]
k_nm_per_rad = 41.0
[drive.motor]
torque_constant_nm_per_a = 2.6
efficiency = 0.75
)");
  }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string believed() const { return " --model " + path("believed.toml") + " "; }
  Ran diagnose(const std::string& arguments) const {
    return run_program("searig diagnose " + arguments);
  }
  nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(std::ifstream(path(name)));
  }

  TemporaryFolder folder_;
};

TEST_F(DiagnoseCommand, AnswersPeopleMachinesAndModelFiles) {
  const Ran ran =
      diagnose(path("made") + believed() + "--json " + path("answer.json") + " --report " +
               path("report.html") + " --write-model " + path("better.toml"));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(ran.err.empty()) << ran.err;  // no terminal, no progress
  EXPECT_NE(ran.out.find("the spring resists being deflected fast"), std::string::npos) << ran.out;

  const auto answer = json("answer.json");
  EXPECT_EQ(answer.at("format"), "searig-diagnosis/1");
  EXPECT_EQ(answer.at("verdict"), "missing_physics");
  const auto& finding = answer.at("findings").at(0);
  EXPECT_EQ(finding.at("effect"), "spring.viscous");
  EXPECT_NEAR(finding.at("parameters").at(0).at("value"), 0.5, 0.03);
  EXPECT_EQ(answer.at("recordings").at(0).at("name"), "made");

  EXPECT_NE(text_of(path("report.html")).find("<!DOCTYPE html>"), std::string::npos);
  EXPECT_NE(text_of(path("better.toml")).find("[spring.viscous]"), std::string::npos);
  const Ran again = diagnose(path("made") + " --model " + path("better.toml") + " --json -");
  EXPECT_EQ(nlohmann::json::parse(again.out).at("verdict"), "consistent");
}

TEST_F(DiagnoseCommand, ExplainsSeveralRecordingsByOneModel) {
  fs::copy(path("made"), path("other"));
  const Ran ran = diagnose(path("made") + " " + path("other") + believed() + "--json " +
                           path("answer.json") + " --report " + path("report.html"));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto answer = json("answer.json");
  ASSERT_EQ(answer.at("recordings").size(), 2u);
  EXPECT_NEAR(answer.at("recordings").at(1).at("from_s").get<double>() -
                  answer.at("recordings").at(0).at("to_s").get<double>(),
              20.0, 0.01);
  EXPECT_EQ(answer.at("findings").at(0).at("effect"), "spring.viscous");
}

TEST_F(DiagnoseCommand, DiagnosesEachByItselfWithAnyNumberOfJobs) {
  fs::copy(path("made"), path("other"));
  const std::string all =
      path("made") + " " + path("nowhere") + " " + path("other") + believed() + "--each --json -";
  const Ran one = diagnose(all + " --jobs 1"), two = diagnose(all + " --jobs 2");
  EXPECT_EQ(one.exit_code, 1);
  EXPECT_EQ(one.out, two.out);
  EXPECT_NE(one.err.find("1 of 3 recordings"), std::string::npos) << one.err;
  const auto answer = nlohmann::json::parse(one.out);
  EXPECT_EQ(answer.at("format"), "searig-diagnoses/1");
  ASSERT_EQ(answer.at("recordings").size(), 2u);
  EXPECT_EQ(answer.at("recordings").at(1).at("name"), "other");
  EXPECT_EQ(answer.at("failed").size(), 1u);
}

TEST_F(DiagnoseCommand, TellsWrongUseFromWorkThatFailed) {
  EXPECT_EQ(diagnose("").exit_code, 2);
  EXPECT_EQ(diagnose(path("made") + " --each --report x.html").exit_code, 2);
  const Ran nowhere = diagnose("/nowhere/at/all");
  EXPECT_EQ(nowhere.exit_code, 1);
  EXPECT_EQ(std::count(nowhere.err.begin(), nowhere.err.end(), '\n'), 1) << nowhere.err;
  folder_.write("broken.toml", "format = \"searig-model/1\"\n[spring.magic]\n");
  EXPECT_NE(diagnose(path("made") + " --model " + path("broken.toml")).err.find("spring.magic"),
            std::string::npos);
  const Ran help = diagnose("--help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("Example:"), std::string::npos);
}

TEST_F(DiagnoseCommand, ProposesAnExperimentThatShowsTheEffectAgain) {
  const Ran ran = diagnose(path("made") + believed() + "--json " + path("a.json") +
                           " --write-experiment " + path("next.toml"));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto motion = json("a.json").at("findings").at(0).at("next_motion");
  EXPECT_GT(motion.at("seconds"), 10.0);
  ASSERT_EQ(
      run_program("searig simulate " + path("next.toml") + " --out " + path("next")).exit_code, 0);
  ASSERT_EQ(diagnose(path("next") + believed() + "--json " + path("b.json")).exit_code, 0);
  EXPECT_EQ(json("b.json").at("findings").at(0).at("effect"), "spring.viscous");
}

TEST_F(DiagnoseCommand, SaysThatThereIsNoExperimentToWrite) {
  folder_.write("truth.toml", R"(format = "searig-model/1"
[spring.linear]
k_nm_per_rad = 40.0
[spring.viscous]
c_nm_s_per_rad = 0.5
[drive.motor]
torque_constant_nm_per_a = 2.6
efficiency = 0.75
)");
  const Ran ran = diagnose(path("made") + " --model " + path("truth.toml") +
                           " --write-experiment " + path("next.toml"));
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find("no motion would tell more"), std::string::npos) << ran.err;
}

TEST_F(DiagnoseCommand, IsVisiblyWorseUnderANegativeControl) {
  const Ran ran =
      diagnose(path("made") + believed() + "--control adapting-stiffness --json " + path("c.json"));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_GT(json("c.json")["paths"]["spring"]["heldout_rmse_nm"]["after"].get<double>(), 0.03);
  EXPECT_EQ(diagnose(path("made") + " --control magic").exit_code, 2);
}

}  // namespace
}  // namespace searig
