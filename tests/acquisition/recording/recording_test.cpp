#include "acquisition/recording/recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition {
namespace {

const char* const kToml =
    "format = \"searig-recording/1\"\n[module]\nfile = \"module.csv\"\ngear_ratio = 349.0\n"
    "[loadcell]\nfile = \"loadcell.csv\"\nlever_arm_m = 0.15\n";

/// A native recording of 200 rows per stream, whose lines a test may spoil.
struct NativeRecording {
  TemporaryFolder folder;
  std::string toml = kToml;
  std::vector<std::string> module{"t_s,host_s,input_angle_rad,output_angle_rad,current_a"};
  std::vector<std::string> loadcell{"t_s,host_s,seq,force_n"};

  NativeRecording() {
    for (int i = 0; i < 200; ++i) {
      const std::string t = std::to_string(0.02 * i);
      module.push_back(t + "," + t + ",0.5,0.25,1.5");
      loadcell.push_back(t + "," + t + "," + std::to_string(i) + ",2.5");
    }
  }

  static std::string text(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += line + '\n';
    return all;
  }

  Recording read() const {
    folder.write("recording.toml", toml);
    folder.write("module.csv", text(module));
    folder.write("loadcell.csv", text(loadcell));
    return read_recording(folder.path());
  }

  std::string refused() const {
    return refusal([&] { read(); });
  }
};

TEST(Recording, HasWhatTheFolderHas) {
  const NativeRecording native;
  const Recording recording = native.read();
  EXPECT_EQ(recording.name, native.folder.path().filename().string());
  EXPECT_EQ(recording.gear_ratio, 349.0);
  EXPECT_EQ(recording.lever_arm_m, 0.15);
  EXPECT_FALSE(recording.one_clock);
  EXPECT_EQ(recording.module.t_s.size(), 200u);
  EXPECT_EQ(recording.module.channel("input_angle_rad")[7], 0.5);
  EXPECT_EQ(recording.loadcell.channel("force_n")[199], 2.5);
  EXPECT_TRUE(recording.loadcell.channel("torque_nm").empty());
  EXPECT_EQ(recording.loadcell.counts.received, 200u);
}

TEST(Recording, WithoutHostStampsInBothIsOnOneClock) {
  NativeRecording native;
  for (std::string& line : native.loadcell)
    line.erase(line.find(','), line.find(',', line.find(',') + 1) - line.find(','));
  EXPECT_EQ(native.loadcell[0], "t_s,seq,force_n");
  EXPECT_TRUE(native.read().one_clock);
}

TEST(Recording, CountsLostDoubledTornAndSwappedRows) {
  NativeRecording native;
  native.module.erase(native.module.begin() + 50);
  native.module.insert(native.module.begin() + 100, native.module[100]);
  native.loadcell.erase(native.loadcell.begin() + 60, native.loadcell.begin() + 63);
  std::swap(native.loadcell[100], native.loadcell[101]);
  native.loadcell.back().resize(5);
  const Recording recording = native.read();
  EXPECT_EQ(recording.module.counts.lost, 1u);
  EXPECT_EQ(recording.module.counts.doubled, 1u);
  EXPECT_EQ(recording.module.counts.received, 199u);
  EXPECT_EQ(recording.loadcell.counts.lost, 3u);
  EXPECT_EQ(recording.loadcell.counts.out_of_order, 1u);
  EXPECT_EQ(recording.loadcell.counts.garbled, 1u);
  EXPECT_TRUE(std::is_sorted(recording.loadcell.t_s.begin(), recording.loadcell.t_s.end()));
}

TEST(Recording, TellsTextAndNaNByFileLineAndColumn) {
  for (const char* bad : {"abc", "nan"}) {
    NativeRecording text;
    text.loadcell[42] = std::string("0.82,0.82,41,") + bad;
    EXPECT_TRUE(
        says(text.refused(), "loadcell.csv, line 43, column force_n: '" + std::string(bad)));
    NativeRecording clock;
    clock.module[7] = std::string(bad) + ",0.1,0.5,0.25,1.5";
    EXPECT_TRUE(says(clock.refused(), "module.csv, line 8, column t_s: '" + std::string(bad)));
  }
}

TEST(Recording, TellsAMissingColumn) {
  NativeRecording clock;
  clock.loadcell[0] = "time,host_s,seq,force_n";
  EXPECT_TRUE(says(clock.refused(), "loadcell.csv, line 1: column t_s is missing"));
  NativeRecording force;
  force.loadcell[0] = "t_s,host_s,seq,weight";
  EXPECT_TRUE(
      says(force.refused(), "loadcell.csv, line 1: column force_n (or torque_nm) is missing"));
  NativeRecording angle;
  angle.module[0] = "t_s,host_s,input_angle_rad,x,current_a";
  EXPECT_TRUE(says(angle.refused(), "module.csv, line 1: column output_angle_rad is missing"));
}

TEST(Recording, TellsAMappedColumnThatTheFileLacks) {
  NativeRecording native;
  native.toml = std::string(kToml) +
                "[loadcell.columns]\nt_s = { column = \"t_s\" }\n"
                "force_n = { column = \"weight\" }\n";
  EXPECT_TRUE(says(native.refused(), "loadcell.csv, line 1: column weight is missing"));
}

TEST(Recording, MissingCurrentOnlySwitchesOffWhatNeedsIt) {
  NativeRecording native;
  native.module[0] = "t_s,host_s,input_angle_rad,output_angle_rad,x";
  EXPECT_TRUE(native.read().module.channel("current_a").empty());
}

TEST(Recording, TellsAClockThatIsNotSorted) {
  NativeRecording reversed;
  std::reverse(reversed.loadcell.begin() + 1, reversed.loadcell.end());
  EXPECT_TRUE(
      says(reversed.refused(), "loadcell.csv, line 3, column t_s: the clock is not sorted"));
  NativeRecording halves;  // host stamps step back as well, so it is no restart
  std::rotate(halves.module.begin() + 1, halves.module.begin() + 101, halves.module.end());
  EXPECT_TRUE(says(halves.refused(), "module.csv, line 102, column t_s: the clock is not sorted"));
  NativeRecording still;
  for (std::size_t i = 1; i < still.module.size(); ++i) still.module[i] = "1.0,1.0,0.5,0.25,1.5";
  EXPECT_TRUE(says(still.refused(), "module.csv, line 3, column t_s"));
}

TEST(Recording, TellsEmptyFilesAndSingleSamples) {
  NativeRecording empty;
  empty.module.clear();
  EXPECT_TRUE(says(empty.refused(), "module.csv, line 1, column 1: the file is empty"));
  NativeRecording single;
  single.loadcell.resize(2);
  EXPECT_TRUE(says(single.refused(), "loadcell.csv, line 2, column t_s: this is the only sample"));
}

TEST(Recording, TellsWhatIsNotThere) {
  TemporaryFolder folder;
  EXPECT_TRUE(says(refusal([&] { read_recording(folder.path() / "none"); }),
                   "none: there is no such recording."));
  EXPECT_TRUE(says(refusal([&] { read_recording(folder.path()); }), "recording.toml: is missing"));
  const auto file = folder.write("a.csv", "1,2\n");
  EXPECT_TRUE(says(refusal([&] { read_recording(file); }), "a.csv: is no recording"));
  folder.write("recording.toml", kToml);
  EXPECT_TRUE(says(refusal([&] { read_recording(folder.path()); }),
                   "module.csv: cannot be read: No such file"));
}

TEST(Recording, TellsAFolderThatMayNotBeRead) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const NativeRecording native;
  native.read();
  std::filesystem::permissions(native.folder.path(), std::filesystem::perms::none);
  const std::string why = refusal([&] { read_recording(native.folder.path()); });
  std::filesystem::permissions(native.folder.path(), std::filesystem::perms::owner_all);
  EXPECT_TRUE(says(why, "Permission denied")) << why;
}

TEST(Recording, NeedsTheLeverArmOfAForce) {
  NativeRecording native;
  native.toml.erase(native.toml.find("lever_arm_m"));
  EXPECT_TRUE(says(native.refused(), "loadcell.lever_arm_m is missing"));
  native.loadcell[0] = "t_s,host_s,seq,torque_nm";
  EXPECT_EQ(native.read().lever_arm_m, 1.0);
}

TEST(Recording, ReadsBothStreamsOfOneFileThroughAMapping) {
  TemporaryFolder folder, elsewhere;
  const auto log = elsewhere.write(
      "log.csv", "time,angle,force,I\n0,90,1000,65533\n20,180,500,7\n40,-90,0,65535\n");
  folder.write("recording.toml",
               "format = \"searig-recording/1\"\n[module]\nfile = \"" + log.string() +
                   "\"\n[module.columns]\n"
                   "t_s = { column = \"time\", unit = \"ms\" }\n"
                   "deflection_rad = { column = \"angle\", unit = \"deg\", scale = -1 }\n"
                   "current_a = { column = 3, unit = \"mA\", wraps_at = 65536 }\n"
                   "[loadcell]\nfile = \"" +
                   log.string() +
                   "\"\nlever_arm_m = 0.1\n[loadcell.columns]\n"
                   "t_s = { column = \"time\", unit = \"ms\" }\nforce_n = { column = \"force\", "
                   "unit = \"g\" }\n");
  const Recording recording = read_recording(folder.path() / "recording.toml");
  EXPECT_TRUE(recording.one_clock);
  EXPECT_EQ(recording.name, folder.path().filename().string());
  EXPECT_NEAR(recording.module.t_s[2], 0.04, 1e-15);
  EXPECT_NEAR(recording.module.channel("deflection_rad")[1], -std::numbers::pi, 1e-15);
  EXPECT_NEAR(recording.module.channel("current_a")[0], -0.003, 1e-15);
  EXPECT_NEAR(recording.loadcell.channel("force_n")[0], 9.80665, 1e-12);
}

}  // namespace
}  // namespace searig::acquisition
