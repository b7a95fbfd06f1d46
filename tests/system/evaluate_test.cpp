// searig evaluate, as a user calls it.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/system/run_program.h"
#include "tests/system/write_spring.h"
#include "tests/temporary_folder.h"

namespace searig {
namespace {

Ran evaluate(const std::string& arguments) {
  return run_program("searig evaluate " + arguments);
}

nlohmann::json read_json(const std::filesystem::path& file) {
  return nlohmann::json::parse(std::ifstream(file));
}

/// A spring of `k` N*m/rad and a motor of 2 N*m/A without friction, all on one clock.
TEST(EvaluateCommand, AnswersWithThePapersTable) {
  const TemporaryFolder folder;
  write_spring(folder.path() / "spring", 40);
  const auto json = folder.path() / "answer.json";
  const Ran ran =
      evaluate((folder.path() / "spring").string() + "/ --initial-k 400 --json " + json.string());
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  for (const char* row : {"Linear (best fit)", "Online", "Motor current"}) {
    EXPECT_NE(ran.out.find(row), std::string::npos) << ran.out << ran.err;
  }
  const auto answer = read_json(json);
  EXPECT_EQ(answer.at("format"), "searig-evaluation/1");
  EXPECT_TRUE(answer.at("failed").empty());
  const auto& recording = answer.at("recordings").at(0);
  EXPECT_EQ(recording.at("name"), "spring");
  EXPECT_NEAR(recording.at("seconds"), 20, 0.01);
  const auto& models = recording.at("models");
  EXPECT_NEAR(models.at("best_fit").at("k_nm_per_rad"), 40, 0.01);
  EXPECT_NEAR(models.at("online").at("k_nm_per_rad"), 40, 1.2);
  for (const char* model : {"best_fit", "online", "current"}) {
    EXPECT_TRUE(models.at(model).at("error_percent").is_number()) << model;
    EXPECT_TRUE(models.at(model).at("rmse_nm").is_number()) << model;
  }
}

TEST(EvaluateCommand, ComparesEstimatorsOfTheStatesThatAreNamed) {
  const TemporaryFolder folder;
  write_spring(folder.path() / "spring", 40);
  const std::string recording = (folder.path() / "spring").string();
  const auto json = folder.path() / "answer.json";
  const Ran ran = evaluate(recording + " --initial-k 80 --estimator all --states " +
                           "spring.linear,spring.cubic --json " + json.string());
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  const auto answer = read_json(json);
  const auto& estimators = answer.at("recordings").at(0).at("estimators");
  ASSERT_EQ(estimators.size(), 4u);
  for (const auto& estimator : estimators) {
    const bool interval =
        estimator.at("estimator") == "linear" || estimator.at("estimator") == "rls";
    const auto& k = estimator.at("parameters").at(0);
    EXPECT_EQ(k.at("name"), "k_nm_per_rad");
    EXPECT_EQ(k.at("ci95").is_array(), interval) << estimator;
    EXPECT_EQ(estimator.contains("why_no_ci95"), !interval) << estimator;
  }
  EXPECT_EQ(evaluate(recording + " --states spring.wobble").exit_code, 2);
  EXPECT_EQ(evaluate(recording + " --estimator best").exit_code, 2);
  const Ran lacking =
      evaluate(recording + " --estimator rls --states spring.linear,spring.relaxation");
  EXPECT_EQ(lacking.exit_code, 1);
  EXPECT_NE(lacking.err.find("tau_s"), std::string::npos) << lacking.err;
}

TEST(EvaluateCommand, ReportsABadRecordingAndDoesTheRest) {
  const TemporaryFolder folder;
  write_spring(folder.path() / "good", 40);
  const auto json = folder.path() / "answer.json";
  const std::string paths =
      (folder.path() / "missing").string() + " " + (folder.path() / "good").string();
  const Ran ran = evaluate(paths + " --json " + json.string());
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find("1 of 2 recordings"), std::string::npos) << ran.out << ran.err;
  const auto answer = read_json(json);
  ASSERT_EQ(answer.at("recordings").size(), 1u);
  EXPECT_EQ(answer.at("recordings").at(0).at("name"), "good");
  ASSERT_EQ(answer.at("failed").size(), 1u);
  EXPECT_EQ(answer.at("failed").at(0).at("name"), "missing");
  EXPECT_FALSE(answer.at("failed").at(0).at("why").get<std::string>().empty());
}

TEST(EvaluateCommand, AnswersTheSameWithAnyNumberOfJobs) {
  const TemporaryFolder folder;
  std::string paths;
  for (int k : {20, 30, 40, 50, 60}) {
    const auto recording = folder.path() / ("spring" + std::to_string(k));
    write_spring(recording, k);
    paths += recording.string() + " ";
  }
  const Ran one = evaluate(paths + "--jobs 1 --json -"),
            four = evaluate(paths + "--jobs 4 --json -");
  EXPECT_EQ(one.exit_code, 0) << one.out;
  EXPECT_EQ(one.out, four.out);
}

TEST(EvaluateCommand, TellsWrongUseFromWorkThatFailed) {
  EXPECT_EQ(evaluate("").exit_code, 2);
  EXPECT_EQ(evaluate("somewhere --initial-k -3").exit_code, 2);
  EXPECT_EQ(evaluate("somewhere --drive guess").exit_code, 2);
  EXPECT_EQ(evaluate("/nowhere/at/all").exit_code, 1);
  const Ran help = evaluate("--help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("Example:"), std::string::npos);
}

}  // namespace
}  // namespace searig
