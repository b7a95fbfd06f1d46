// searig evaluate, diagnose and merge over folders of recordings, as a user calls them.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "tests/system/run_program.h"
#include "tests/system/write_spring.h"
#include "tests/temporary_folder.h"

namespace searig {
namespace {

namespace fs = std::filesystem;

/// Springs of 30 N*m/rad and more, one bad recording among them.
class BatchCommand : public testing::Test {
 protected:
  static constexpr int count = 12;

  BatchCommand() {
    for (int i = 0; i < count; ++i)
      write_spring(folder_.path() / "all" / ("r" + std::to_string(100 + i)), 30.0 + i);
    folder_.write("all/r105/loadcell.csv", "t_s,torque_nm\n0,abc\n1,2\n");
  }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  Ran evaluate(const std::string& arguments) const {
    return run_program("searig evaluate " + path("all") + " " + arguments);
  }

  /// All that a batch leaves for people and machines.
  std::string bytes_of(const std::string& out) const {
    std::string all;
    for (const char* file : {"evaluation.json", "summary.csv", "report.html"})
      all += text_of(folder_.path() / out / file) + "\n";
    return all;
  }

  TemporaryFolder folder_;
};

TEST_F(BatchCommand, EvaluatesAFolderWithOneBadRecordingInIt) {
  const Ran ran = evaluate("--jobs 1 --out " + path("out"));
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.out.find("11 of 12 recordings evaluated, 1 failed: "), std::string::npos)
      << ran.out;
  EXPECT_NE(ran.err.find("r105/loadcell.csv, line 2, column torque_nm"), std::string::npos)
      << ran.err;
  const auto answer = nlohmann::json::parse(text_of(folder_.path() / "out/evaluation.json"));
  EXPECT_EQ(answer.at("format"), "searig-evaluation/1");
  EXPECT_EQ(answer.at("recordings").size(), 11u);
  EXPECT_EQ(answer.at("recordings").at(1).at("path"), path("all/r101"));
  EXPECT_NEAR(answer.at("recordings").at(1).at("models").at("best_fit").at("k_nm_per_rad"), 31,
              0.01);
  EXPECT_EQ(answer.at("failed").at(0).at("name"), "r105");

  evaluate("--jobs 3 --out " + path("again"));
  EXPECT_EQ(bytes_of("out"), bytes_of("again"));
  EXPECT_EQ(evaluate("--out " + path("out")).exit_code, 1);
}

TEST_F(BatchCommand, GoesOnAfterAKillWithTheSameBytes) {
  evaluate("--out " + path("whole"));
  const pid_t child = fork();
  if (child == 0) {
    const std::string program = std::string(SEARIG_BINARY_DIR) + "/searig";
    if (!freopen("/dev/null", "w", stdout) || !freopen("/dev/null", "w", stderr)) _exit(9);
    execl(program.c_str(), "searig", "evaluate", path("all").c_str(), "--jobs", "1", "--out",
          path("out").c_str(), nullptr);
    _exit(9);
  }
  const fs::path journal = folder_.path() / "out/batch.jsonl";
  const auto lines = [&] {
    const std::string text = text_of(journal);
    return std::count(text.begin(), text.end(), '\n');
  };
  while (lines() < 4 && waitpid(child, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  std::ofstream(journal, std::ios::app) << R"({"index":11,"path":)";  // a line that was torn

  const Ran resumed = evaluate("--resume --out " + path("out"));
  EXPECT_EQ(resumed.exit_code, 1) << resumed.err;
  EXPECT_EQ(bytes_of("out"), bytes_of("whole"));
}

TEST_F(BatchCommand, MergesEightShardsIntoWhatOneMachineGives) {
  evaluate("--out " + path("whole"));
  std::string shards;
  for (int i = 1; i <= 8; ++i) {
    const std::string shard = path("shard" + std::to_string(i));
    evaluate("--shard " + std::to_string(i) + "/8 --out " + shard);
    shards += shard + " ";
  }
  const Ran merged = run_program("searig merge " + shards + "--out " + path("merged"));
  EXPECT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(bytes_of("merged"), bytes_of("whole"));

  fs::remove_all(path("shard3"));
  EXPECT_EQ(run_program("searig merge " + shards + "--out " + path("m")).exit_code, 1);
  EXPECT_EQ(run_program("searig merge " + path("whole") + " --out " + path("whole")).exit_code, 1);
}

TEST_F(BatchCommand, TakesAListInItsOrder) {
  folder_.write("list", "# two\n" + path("all/r107") + "\n" + path("all/r102") + "\n");
  const Ran ran = run_program("searig evaluate --list " + path("list") + " --json -");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  const auto answer = nlohmann::json::parse(ran.out);
  EXPECT_EQ(answer.at("recordings").at(0).at("name"), "r107");
  EXPECT_EQ(answer.at("recordings").at(1).at("name"), "r102");
}

TEST_F(BatchCommand, DiagnosesAFolderEachByItself) {
  for (int i = 2; i < count; ++i) fs::remove_all(path("all/r" + std::to_string(100 + i)));
  folder_.write("all/bad.mcap", "");
  const Ran ran = run_program("searig diagnose " + path("all") + " --json - --out " + path("out"));
  EXPECT_EQ(ran.exit_code, 1);
  const auto answer = nlohmann::json::parse(ran.out);
  EXPECT_EQ(answer.at("format"), "searig-diagnoses/1");
  EXPECT_EQ(answer.at("recordings").size(), 2u);
  EXPECT_EQ(answer.at("recordings").at(1).at("path"), path("all/r101"));
  EXPECT_EQ(answer.at("failed").size(), 1u);
  EXPECT_NE(text_of(folder_.path() / "out/report.html").find("Findings by kind"),
            std::string::npos);
  const Ran wrong = run_program("searig diagnose " + path("all") + " --report x.html");
  EXPECT_EQ(wrong.exit_code, 2) << wrong.err;
}

TEST_F(BatchCommand, TellsWrongUse) {
  for (const char* wrong : {"--shard 9/8 --out x", "--shard 1/2", "--resume", "--shard a --out x"})
    EXPECT_EQ(evaluate(wrong).exit_code, 2) << wrong;
  EXPECT_EQ(run_program("searig evaluate").exit_code, 2);
  EXPECT_EQ(run_program("searig evaluate --list " + path("nowhere")).exit_code, 1);
}

}  // namespace
}  // namespace searig
