#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/system/run_program.h"

namespace searig {
namespace {

/// One demo for all tests here; it is the longest thing they do.
class Demo : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    ran_ = run_program("searig demo --seconds 20 --headless --out " + out() + " --json " +
                       (folder_->path() / "demo.json").string());
  }
  static void TearDownTestSuite() { delete folder_; }

  static std::string out() { return (folder_->path() / "out").string(); }
  static nlohmann::json answer() {
    return nlohmann::json::parse(text_of(folder_->path() / "demo.json"));
  }

  static inline TemporaryFolder* folder_ = nullptr;
  static inline Ran ran_;
};

TEST_F(Demo, SaysInAFewLinesWhatItDid) {
  EXPECT_EQ(ran_.exit_code, 0) << ran_.err;
  EXPECT_NE(ran_.out.find("Recording kept: "), std::string::npos);
  EXPECT_NE(ran_.out.find("Stiffness: from 400 to "), std::string::npos);
  EXPECT_LE(std::count(ran_.out.begin(), ran_.out.end(), '\n'), 10);
  EXPECT_TRUE(ran_.err.empty()) << ran_.err;
}

TEST_F(Demo, FindsTheStiffnessOfTheSimulatedSpring) {
  const auto found = answer();
  EXPECT_EQ(found["format"], "searig-demo/1");
  const double truth = found["true_stiffness_nm_per_rad"];
  EXPECT_NEAR(found["models"]["online_ten_times_too_high"]["k_nm_per_rad"], truth, 0.06 * truth);
  EXPECT_LT(found["models"]["online"]["error_percent"], 5.0);
  EXPECT_LT(found["models"]["best_fit"]["error_percent"], 7.0);
}

TEST_F(Demo, PlacesTheClocksByPingsWithinTheirInterval) {
  const auto clock = answer()["loadcell_to_module"];
  EXPECT_TRUE(clock["trusted"]);
  EXPECT_LT(clock["ci95_s"], 1e-3);
  EXPECT_LE(std::abs(double(clock["error_s"])), double(clock["ci95_s"]));
}

TEST_F(Demo, KeepsARecordingThatTheOtherCommandsTake) {
  const std::string recording = out() + "/recording.mcap";
  const Ran sync = run_program("searig sync " + recording + " --json -");
  ASSERT_EQ(sync.exit_code, 0) << sync.err;
  EXPECT_NEAR(nlohmann::json::parse(sync.out)["loadcell_to_module"]["rate"], 1.0003241, 5e-5);
  const Ran evaluate = run_program("searig evaluate " + recording + " --json -");
  ASSERT_EQ(evaluate.exit_code, 0) << evaluate.err;
  const auto models = nlohmann::json::parse(evaluate.out)["recordings"][0]["models"];
  EXPECT_NEAR(models["online"]["k_nm_per_rad"],
              answer()["models"]["online_ten_times_too_high"]["k_nm_per_rad"], 1e-6);
}

TEST_F(Demo, LeavesAReportThatStandsAlone) {
  const std::string report = text_of(out() + "/report.html");
  for (const char* words : {"<!DOCTYPE html>", "Linear (best fit)", "Motor current", "<svg",
                            "Trust in the motor current", "95 % interval"}) {
    EXPECT_NE(report.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(report.find("nan"), std::string::npos);
}

#ifdef SEARIG_HAS_DESKTOP
TEST_F(Demo, LeavesPicturesOfTheWindow) {
  for (const char* picture : {"/desktop-live.png", "/desktop-recording.png"}) {
    EXPECT_GT(text_of(out() + picture).size(), 10000u) << picture;
  }
}
#endif

/// The simulated rubber softens and relaxes, in other forms than the catalogue's; it is not cubic.
TEST(DemoUse, OfARecordingOfAMinuteNothingIsSaidThatIsNotThere) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  ASSERT_EQ(run_program("searig demo --headless --out " + out).exit_code, 0);
  const Ran ran = run_program("searig diagnose " + out + "/recording.mcap --json - --out " + out +
                              "/diagnosis");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto answer = nlohmann::json::parse(ran.out);
  std::set<std::string> found;
  for (const auto& finding : answer["recordings"][0]["findings"]) found.insert(finding["effect"]);
  EXPECT_EQ(found, (std::set<std::string>{"spring.mullins", "spring.relaxation"}));
}

TEST(DemoUse, WrongUseIsSaidAndExits2) {
  EXPECT_EQ(run_program("searig demo --seconds fast").exit_code, 2);
  EXPECT_EQ(run_program("searig demo --seconds -1").exit_code, 2);
  EXPECT_EQ(run_program("searig demo --nonsense").exit_code, 2);
  EXPECT_EQ(run_program("searig").exit_code, 2);
}

TEST(DemoUse, AFolderThatCannotBeWrittenExits1) {
  const Ran ran = run_program("searig demo --seconds 5 --headless --out /proc/nowhere");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find("/proc/nowhere"), std::string::npos) << ran.err;
}

TEST(CommandLine, EveryCommandHelpsWithAnExample) {
  for (const char* command : {"demo", "desktop", "info", "sync", "evaluate", "export"}) {
    const Ran ran = run_program("searig " + std::string(command) + " --help");
    EXPECT_EQ(ran.exit_code, 0) << command;
    EXPECT_NE(ran.out.find("Example"), std::string::npos) << command;
  }
}

TEST(CommandLine, LinksNoGuiLibrary) {
  const TemporaryFolder folder;
  const auto list = (folder.path() / "libraries").string();
  ASSERT_EQ(std::system(("ldd " SEARIG_BINARY_DIR "/searig >" + list).c_str()), 0);
  EXPECT_EQ(text_of(list).find("Qt5"), std::string::npos);
  EXPECT_EQ(text_of(list).find("qwt"), std::string::npos);
}

}  // namespace
}  // namespace searig
