#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/system/run_program.h"

namespace searig {
namespace {

class Reproduce : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    ran_ = run_program("searig reproduce --seeds 3 --out " + out() + " --json " + out("a.json"));
    if (ran_.exit_code == 0) answer_ = nlohmann::json::parse(text_of(out("a.json")));
  }
  static void TearDownTestSuite() { delete folder_; }

  static std::string out(const std::string& file = "") {
    return (folder_->path() / "out" / file).string();
  }

  static inline TemporaryFolder* folder_ = nullptr;
  static inline Ran ran_;
  static inline nlohmann::json answer_;
};

TEST_F(Reproduce, OnlineIsAsGoodAsTheBestFitAndFarBetterThanTheCurrent) {
  ASSERT_EQ(ran_.exit_code, 0) << ran_.err;
  EXPECT_EQ(answer_["format"], "searig-reproduction/1");
  const auto& table = answer_["table_1"];
  EXPECT_EQ(table["current"]["paper_percent"], 21.0);
  for (const char* variant : {"paper", "searig", "searig_friction"}) {
    const auto& targets = answer_["targets"][variant];
    EXPECT_TRUE(targets["online_over_best_fit"]["met"]) << variant << targets;
    EXPECT_TRUE(targets["online_over_current"]["met"]) << variant << targets;
    EXPECT_LT(targets["online_over_current"]["value"], 0.5) << variant;
  }
  // Not what the paper says of its stiffness, but how near the twin lets it come.
  const auto& stiffness =
      answer_["targets"]["paper"]["stiffness_within_5_percent_at_trust_weight_5_s"];
  EXPECT_EQ(stiffness["trials_reached"], 3);
  EXPECT_LT(stiffness["worst_off_percent"], 20.0);
}

// Friction changes sides when the hand drives the train, and the heuristic does not see it.
TEST_F(Reproduce, TellsThatTheHeuristicNeedsAMotorThatDrives) {
  ASSERT_EQ(ran_.exit_code, 0) << ran_.err;
  const double held = answer_["table_1"]["online_paper"]["error_percent"];
  const double dragged = answer_["hand_drags"]["table_1"]["online_paper"]["error_percent"];
  EXPECT_GT(dragged, 1.5 * held);
  EXPECT_NE(text_of(out("reproduction.html")).find("hand drags along"), std::string::npos);
}

TEST_F(Reproduce, LeavesEveryFigureAsPngAndCsv) {
  ASSERT_EQ(answer_["figures"].size(), 9u);
  for (const auto& figure : answer_["figures"]) {
    const std::string png = text_of(out(figure["png"])), csv = text_of(out(figure["csv"]));
    EXPECT_EQ(png.substr(1, 3), "PNG") << figure;
    EXPECT_GT(png.size(), 10000u) << figure;
    EXPECT_NE(csv.find(','), std::string::npos) << figure;
    EXPECT_TRUE(figure["agrees"]) << figure;
  }
}

TEST_F(Reproduce, ThePageStandsAlone) {
  const std::string page = text_of(out("reproduction.html"));
  for (const char* words : {"<!DOCTYPE html>", "In the paper", "On the twin", "Figure 11",
                            ">chosen: ", "paper, section III<", "Every number of the twin",
                            "chosen", "Heuristic Weight"}) {
    EXPECT_NE(page.find(words), std::string::npos) << words;
  }
  for (const char* outside : {"src=", "href=", "@import", "nan", "inf "}) {
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  }
}

TEST(ReproduceUse, ExitCodesAndHelp) {
  EXPECT_EQ(run_program("searig reproduce").exit_code, 2);
  EXPECT_EQ(run_program("searig reproduce --out x --seeds 0").exit_code, 2);
  EXPECT_NE(run_program("searig reproduce --help").out.find("Example"), std::string::npos);
  const Ran ran = run_program("searig reproduce --seeds 1 --out /proc/nowhere");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find("/proc/nowhere"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace searig
