#include "acquisition/recording/mapping.h"

#include <gtest/gtest.h>

#include "acquisition/recording/units.h"
#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition {
namespace {

const std::string kModule = "format = \"searig-recording/1\"\n[module]\nfile = \"m.csv\"\n";
const std::string kLoadcell = "[loadcell]\nfile = \"l.csv\"\n";

RecordingMapping read(const std::string& toml) {
  TemporaryFolder folder;
  return read_mapping(folder.write("recording.toml", toml));
}

TEST(Mapping, TakesNativeStreamsStrictlyAndMappedOnesAsLogs) {
  const RecordingMapping native = read(kModule + kLoadcell);
  EXPECT_TRUE(native.module.native);
  EXPECT_EQ(native.module.faults, Faults::refuse);
  const std::string columns =
      "[loadcell.columns]\nt_s = { column = \"time\" }\n"
      "torque_nm = { column = \"T\" }\n";
  EXPECT_EQ(read(kModule + kLoadcell + columns).loadcell.faults, Faults::count);
  EXPECT_EQ(read(kModule + kLoadcell + "faults = \"refuse\"\n" + columns).loadcell.faults,
            Faults::refuse);
}

TEST(Mapping, FindsFilesBesideItAndElsewhere) {
  TemporaryFolder folder;
  const auto toml = folder.write(
      "recording.toml",
      "format = \"searig-recording/1\"\n[module]\nfile = \"/data/m.csv\"\n" + kLoadcell);
  const RecordingMapping mapping = read_mapping(toml);
  EXPECT_EQ(mapping.module.file, "/data/m.csv");
  EXPECT_EQ(mapping.loadcell.file, folder.path() / "l.csv");
}

TEST(Mapping, ReadsDeclaredLatencies) {
  const auto mapping =
      read(kModule + kLoadcell + "host_latency_s = 0.002\nhost_latency_ci95_s = 3e-4\n");
  EXPECT_FALSE(mapping.module.host_latency);
  EXPECT_EQ(mapping.loadcell.host_latency->latency_s, 0.002);
  EXPECT_EQ(mapping.loadcell.host_latency->ci95_s, 3e-4);
}

TEST(Mapping, SaysWhatIsWrongAndOnWhichLine) {
  const auto why = [](const std::string& toml) { return refusal([&] { read(toml); }); };
  const std::string columns = kModule + kLoadcell + "[loadcell.columns]\n";
  EXPECT_TRUE(says(why("format = \n"), "recording.toml, line 1"));
  EXPECT_TRUE(says(why("a = 1\n"), "format must be"));
  EXPECT_TRUE(says(why(kModule), "the section [loadcell] is missing"));
  EXPECT_TRUE(says(why(kModule + "[loadcell]\n"), "line 4: loadcell.file is missing"));
  EXPECT_TRUE(
      says(why(kModule + "gear_ratio = \"high\"\n" + kLoadcell), "line 4: module.gear_ratio"));
  EXPECT_TRUE(says(why(kModule + "gear_ratio = -2\n" + kLoadcell), "must be positive"));
  EXPECT_TRUE(says(why(columns + "t_s = { column = \"t\", unit = \"deg\" }\n"),
                   "line 7: loadcell.columns.t_s.unit 'deg' is none of s, ms, us"));
  EXPECT_TRUE(says(why(columns + "torque = { column = \"t\" }\n"), "there is no such channel"));
  EXPECT_TRUE(says(why(columns + "t_s = { unit = \"ms\" }\n"), "t_s.column is missing"));
}

TEST(Mapping, SaysWhichMappedColumnIsOfNoUse) {
  const auto why = [](const std::string& toml) { return refusal([&] { read(toml); }); };
  const std::string columns = kModule + kLoadcell + "[loadcell.columns]\n";
  const std::string clock = "t_s = { column = \"t\" }\n";
  EXPECT_TRUE(says(why(columns + "t_s = \"time\"\n"),
                   "line 7: loadcell.columns.t_s must be a table such as { column = "));
  EXPECT_TRUE(says(why(columns + "t_s = { column = \"t\", scale = 0 }\n"),
                   "line 7: loadcell.columns.t_s.scale must not be zero"));
  EXPECT_TRUE(
      says(why(columns + "force_n = { column = \"F\" }\n"), "line 6: loadcell.columns lacks t_s"));
  EXPECT_TRUE(says(why(columns + clock), "loadcell.columns lacks force_n (or torque_nm)"));
  EXPECT_TRUE(says(why(kModule + "[module.columns]\n" + clock + kLoadcell),
                   "line 4: module.columns lacks deflection_rad"));
  EXPECT_TRUE(says(why(kModule + kLoadcell + "lever_arm_m = 0\n"),
                   "line 6: loadcell.lever_arm_m must not be zero"));
  EXPECT_TRUE(says(why("format = \"searig-recording/1\"\nmodule = 3\n" + kLoadcell),
                   "line 2: module must be a table"));
}

TEST(Units, BringEachToItsSiUnit) {
  const auto si = [](const char* unit, double value) {
    const UnitScale scale = find_unit(unit)->to_si;
    return scale.factor * value + scale.offset;
  };
  EXPECT_NEAR(si("deg", 180.0), 3.14159265358979, 1e-14);
  EXPECT_NEAR(si("rpm", 60.0), 6.28318530717959, 1e-14);
  EXPECT_NEAR(si("kg", 2.0), 19.6133, 1e-12);
  EXPECT_NEAR(si("mNm", 5.0), 0.005, 1e-15);
  EXPECT_NEAR(si("K", 300.0), 26.85, 1e-12);
  EXPECT_NEAR(si("degF", 212.0), 100.0, 1e-12);
  EXPECT_NEAR(si("us", 3.0), 3e-6, 1e-18);
  EXPECT_FALSE(find_unit("parsec"));
  EXPECT_EQ(channel_unit("current_a"), "A");
}

}  // namespace
}  // namespace searig::acquisition
