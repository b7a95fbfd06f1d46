// Further devices in recording.toml: what they supply, what aligns them, what is refused.
#include <gtest/gtest.h>

#include "acquisition/recording/recording.h"
#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition {
namespace {

const std::string kStreams =
    "format = \"searig-recording/1\"\n[module]\nfile = \"m.csv\"\n[loadcell]\nfile = \"l.csv\"\n";

/// A folder whose module has a current and a velocity, and whose device has an angle.
struct Folder : TemporaryFolder {
  Folder() {
    write("m.csv", "t_s,current_a,input_velocity_rad_s\n0,1,1\n1,2,1\n2,3,1\n");
    write("l.csv", "t_s,torque_nm\n0,1\n1,2\n2,3\n");
    write("d.csv", "t_s,input_angle_rad,current_a\n10,0,0\n11,1,0\n12,2,0\n");
    write("plain.csv", "10,50\n11,100\n12,150\n");
    write("angles.csv", "t_s,input_angle_rad\n10,0\n11,1\n12,2\n");
  }
  Recording with(const std::string& devices) const {
    write("recording.toml", kStreams + devices);
    return read_recording(path());
  }
  std::string why(const std::string& devices) const {
    return refusal([&] { with(devices); });
  }
};

TEST(Device, SuppliesAChannelFromAFileWithoutAHeader) {
  const Recording recording = Folder().with(
      "[device.encoder]\nfile = \"plain.csv\"\naligned_by = "
      "\"velocity\"\n[device.encoder.columns]\n"
      "t_s = { column = 0 }\ninput_angle_rad = { column = 1, scale = 0.02 }\n");
  ASSERT_EQ(recording.devices.size(), 1u);
  const Device& device = recording.devices.front();
  EXPECT_EQ(device.stream.name, "device.encoder");
  EXPECT_EQ(device.aligned_by, AlignedBy::velocity);
  EXPECT_EQ(device.stream.channel("input_angle_rad"), (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_TRUE(recording.module.channel("input_angle_rad").empty());
}

TEST(Device, ARecordingNeedsNone) {
  EXPECT_TRUE(Folder().with("").devices.empty());
}

TEST(Device, SaysWhatIsWrong) {
  const Folder folder;
  const auto why = [&](const std::string& devices) { return folder.why(devices); };
  EXPECT_TRUE(says(why("[device.a]\n"), "line 6: device.a.file is missing"));
  EXPECT_TRUE(says(why("[device]\na = 1\n"), "device.a must be a table"));
  EXPECT_TRUE(says(why("[device.a]\nfile = \"angles.csv\"\naligned_by = \"luck\"\n"),
                   "line 8: device.a.aligned_by must be \"host\", \"clock\" or \"velocity\""));
  EXPECT_TRUE(says(why("[device.a]\nfile = \"angles.csv\"\n"), "cannot be aligned by host"));
  EXPECT_TRUE(says(why("[device.a]\nfile = \"d.csv\"\naligned_by = \"clock\"\n"),
                   "device.a supplies current_a, which the module already has"));
  EXPECT_TRUE(says(why("[device.a]\nfile = \"angles.csv\"\naligned_by = \"clock\"\n"
                       "[device.b]\nfile = \"angles.csv\"\naligned_by = \"clock\"\n"),
                   "device.b supplies input_angle_rad, which device.a already does"));
  EXPECT_TRUE(says(why("[device.a]\nfile = \"plain.csv\"\naligned_by = \"velocity\"\n"
                       "[device.a.columns]\nt_s = { column = 0 }\n"
                       "winding_temperature_c = { column = 1 }\n"),
                   "it has no input_angle_rad and no motor_angle_rad"));
  EXPECT_TRUE(says(why("[device.a]\nfile = \"plain.csv\"\naligned_by = \"clock\"\n"
                       "[device.a.columns]\nt_s = { column = 0 }\n"),
                   "device.a.columns lacks a channel beside its clock"));
}

}  // namespace
}  // namespace searig::acquisition
