// searig export and import, as a user calls them.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "acquisition/exchange/sha256.h"
#include "acquisition/recording/write_recording.h"
#include "app/rig/simulated_rig.h"
#include "tests/system/answer_wherever.h"
#include "tests/system/run_program.h"

namespace searig {
namespace {

namespace fs = std::filesystem;

/// Four seconds of the simulated rig in a folder, with a model beside them.
class Export : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    home_ = new TemporaryFolder;
    app::SimulatedRig rig;
    rig.run_until(4.0);
    acquisition::write_recording(rig.recording(), at("rig"));
    std::ofstream(at("rig/model.toml")) << "format = \"searig-model/1\"\n[spring.linear]\n"
                                           "k_nm_per_rad = 40.0\n";
  }
  static void TearDownTestSuite() { delete home_; }
  static std::string at(const std::string& name) { return (home_->path() / name).string(); }

  static inline TemporaryFolder* home_ = nullptr;
};

TEST_F(Export, EveryFormatComesBackAsTheSameRecording) {
  for (const std::string format : {"csv", "mat", "hdf5"}) {
    SCOPED_TRACE(format);
    const std::string folder = at(format), file = folder + "/rig." + format;
    fs::create_directories(folder + "/again");
    const std::string how = " --long --format " + format + " --out ";
    const Ran once = run_program("searig export " + at("rig") + how + file);
    ASSERT_EQ(once.exit_code, 0) << once.err;
    const Ran back = run_program("searig import " + file + " --out " + folder + "/rig.mcap");
    ASSERT_EQ(back.exit_code, 0) << back.err;
    const std::string again = folder + "/again/rig." + format;
    const Ran twice = run_program("searig export " + folder + "/rig.mcap" + how + again);
    ASSERT_EQ(twice.exit_code, 0) << twice.err;
    EXPECT_TRUE(text_of(file) == text_of(again));
    EXPECT_EQ(answer_wherever("evaluate", at("rig")),
              answer_wherever("evaluate", folder + "/rig.mcap"));
    EXPECT_EQ(answer_wherever("sync", at("rig")), answer_wherever("sync", folder + "/rig.mcap"));
  }
}

TEST_F(Export, TheSidecarHasTheSyncReportAndTheHashes) {
  const Ran ran = run_program("searig export " + at("rig") + " --format mat --out " + at("s.mat"));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto report = nlohmann::json::parse(text_of(at("s.mat.json")));
  EXPECT_EQ(report.at("export").at("sha256"), acquisition::exchange::sha256_of(at("s.mat")));
  ASSERT_EQ(report.at("sources").size(), 4u);  // recording.toml, the model, two streams
  for (const auto& source : report.at("sources"))
    EXPECT_EQ(source.at("sha256"),
              acquisition::exchange::sha256_of(source.at("file").get<std::string>()));
  const Ran sync = run_program("searig sync " + at("rig") + " --json -");
  EXPECT_EQ(report.at("sync"), nlohmann::json::parse(sync.out));
}

TEST_F(Export, ReplacesAFileOnlyWhenTold) {
  std::ofstream(at("there.csv")) << "mine";
  const std::string command = "searig export " + at("rig") + " --out " + at("there.csv");
  const Ran refused = run_program(command);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find("there.csv: is there already; --overwrite"), std::string::npos)
      << refused.err;
  EXPECT_EQ(text_of(at("there.csv")), "mine");
  EXPECT_EQ(run_program(command + " --overwrite").exit_code, 0);
  EXPECT_NE(text_of(at("there.csv")), "mine");
}

TEST_F(Export, AFullDiskLeavesNothingBehind) {
  fs::create_directories(at("full"));
  for (const std::string format : {"csv", "mat", "hdf5"}) {
    const Ran ran = run_program("searig export " + at("rig") + " --long --format " + format +
                                    " --out " + at("full/rig." + format),
                                "prlimit --fsize=50000 env --ignore-signal=XFSZ ");
    EXPECT_EQ(ran.exit_code, 1) << ran.err;
    EXPECT_NE(ran.err.find("full/rig." + format + ": "), std::string::npos) << ran.err;
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  }
  EXPECT_TRUE(fs::is_empty(at("full")));
}

TEST_F(Export, AHebiLogIsARecordingOfTheModuleAlone) {
  const fs::path log = fs::path(SEARIG_SHARED_DIR) / "data/hebi_x5_log/exampleLog.hebilog";
  if (!fs::exists(log)) GTEST_SKIP() << log << " is not there";
  const Ran ran = run_program("searig import " + log.string() + " --gear-ratio 272.222 --out " +
                              at("hebi.mcap"));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto info =
      nlohmann::json::parse(run_program("searig info " + at("hebi.mcap") + " --json -").out);
  EXPECT_EQ(info.at("gear_ratio"), 272.222);
  EXPECT_EQ(info.at("streams").at(0).at("received"), 1000);
  const Ran evaluated = run_program("searig evaluate " + at("hebi.mcap") + " --json -");
  EXPECT_EQ(evaluated.exit_code, 1);
  EXPECT_NE(evaluated.err.find("no load cell"), std::string::npos) << evaluated.err;
  const Ran table = run_program("searig export " + at("hebi.mcap") + " --out " + at("t.csv"));
  EXPECT_EQ(table.exit_code, 1);
  EXPECT_NE(table.err.find("--long writes it all"), std::string::npos) << table.err;
}

}  // namespace
}  // namespace searig
