// searig record as a user calls it: what it keeps, what it refuses, what a kill -9 costs.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "acquisition/recording/recording.h"
#include "tests/system/running_record.h"

namespace searig {
namespace {

namespace fs = std::filesystem;
using acquisition::Recording;

TEST(Record, TheSimulatedRigIntoAFileThatOtherCommandsTake) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  const Ran ran = run_program(record(file, "--seconds 3 --json -"));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto answer = nlohmann::json::parse(ran.out);
  EXPECT_EQ(answer["format"], "searig-record/1");
  const Recording recording = acquisition::read_recording(file);
  EXPECT_EQ(recording.cut_off, "");
  EXPECT_GT(recording.module.t_s.size(), 1000u);
  EXPECT_EQ(answer["streams"][0]["received"], recording.module.t_s.size());
  EXPECT_EQ(recording.module.counts.lost, 0u);
  EXPECT_EQ(recording.loadcell.counts.lost, 0u);
  EXPECT_EQ(recording.gear_ratio, 349.0);
  EXPECT_DOUBLE_EQ(recording.lever_arm_m, 0.15);
  const Ran info = run_program("searig info " + file.string());
  EXPECT_NE(info.out.find("connected"), std::string::npos);
  EXPECT_NE(info.out.find("\"loadcell\", firmware 1, 50 Hz"), std::string::npos) << info.out;
}

TEST(Record, WritesOverNothing) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("mine.mcap", "precious");
  const Ran ran = run_program(record(file, "--seconds 1"));
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find("mine.mcap: is there already"), std::string::npos) << ran.err;
  EXPECT_EQ(text_of(file), "precious");
}

TEST(Record, SaysBeforeItBeginsThatTheDiskHasTooLittleRoom) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  const Ran ran = run_program(record(file, "--seconds 1 --least-free-gb 1e9"));
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find("GB left, and a recording wants"), std::string::npos) << ran.err;
  EXPECT_FALSE(fs::exists(file));
}

TEST(Record, SaysWhereItMayNotWriteOrWhatIsNoSource) {
  const Ran nowhere = run_program(record("/proc/none/a.mcap", "--seconds 1 --least-free-gb 0"));
  EXPECT_EQ(nowhere.exit_code, 1);
  EXPECT_NE(nowhere.err.find("/proc/none/a.mcap: cannot be made: "), std::string::npos);
  const Ran source =
      run_program("searig record --loadcell nothing --module sim: --out /tmp/never.mcap");
  EXPECT_EQ(source.exit_code, 1);
  EXPECT_NE(source.err.find("'nothing' is no source"), std::string::npos) << source.err;
  EXPECT_FALSE(fs::exists("/tmp/never.mcap"));
}

TEST(Record, SaysWhatTheSimulatedRigLacks) {
  const TemporaryFolder folder;
  const std::string alone = (folder.path() / "searig").string();  // nothing beside it
  fs::copy_file(std::string(SEARIG_BINARY_DIR) + "/searig", alone);
  const std::string out = (folder.path() / "a.mcap").string();
  const Ran ran = run_program("searig", "sh -c '" + alone +
                                            " record --loadcell sim: --module sim: " + "--out " +
                                            out + " --seconds 1' ");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find("avr-gcc, the Arduino core for AVR and simavr"), std::string::npos)
      << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
  EXPECT_FALSE(fs::exists(out));
}

void expect_kept(const Ran& ran, const fs::path& file, const char* why) {
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find(why), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find(" s until then are kept."), std::string::npos) << ran.err;
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1);
  const Recording kept = acquisition::read_recording(file);
  EXPECT_GT(kept.module.t_s.size(), 200u);
}

TEST(Record, AFileThatMayNotGrowEndsItAtOnceAndKeepsWhatThereIs) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  const Ran ran = run_program(record(file, "--seconds 30"),
                              "bash -c 'ulimit -f 100; exec \"$@\"' sh ");  // of 1024 bytes
  expect_kept(ran, file, "cannot be written further: File too large");
}

TEST(Record, AFullDiskEndsItAtOnceAndKeepsWhatThereIs) {
  const TemporaryFolder folder;
  const std::string disk = (folder.path() / "disk").string();
  const fs::path file = folder.path() / "kept.mcap";
  fs::create_directory(disk);
  const std::string mount = "mount -t tmpfs -o size=100k none " + disk;
  if (std::system(("unshare -m sh -c '" + mount + "' 2>/dev/null").c_str()) != 0)
    GTEST_SKIP() << "this user may not mount a small disk";
  // The disk is only there for the program; what it holds is copied out before it goes.
  const Ran ran = run_program(record(disk + "/a.mcap", "--seconds 30 --least-free-gb 0"),
                              "unshare -m sh -c '" + mount + "; \"$@\"; code=$?; cp " + disk +
                                  "/a.mcap " + file.string() + "; exit $code' sh ");
  expect_kept(ran, file, "cannot be written further: No space left on device");
}

TEST(Record, CtrlCEndsItCleanly) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.mcap";
  Running running(recording_words(file));
  sleep_s(1.5);
  EXPECT_EQ(running.end(SIGINT), 0);
  EXPECT_EQ(acquisition::read_recording(file).cut_off, "");
}

// How long is lost depends on how busy the machine is; the long test states it.
TEST(Record, KilledAtOnceEverySampleBeforeIsIntact) {
  std::printf("5 kills: at most %.0f ms lost\n", 1e3 * worst_loss_of_kills(5, 1.5));
}

}  // namespace
}  // namespace searig
