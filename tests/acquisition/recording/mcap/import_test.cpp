#include "acquisition/recording/mcap/import.h"

#include <gtest/gtest.h>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "acquisition/recording/write_recording.h"
#include "tests/acquisition/clock/simulated_device.h"
#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition::mcap {
namespace {

Recording a_recording() {
  std::mt19937_64 random(1);
  SimulatedPair pair;
  pair.loadcell.lost_share = 0.01;
  Recording recording = pair.record(random);
  std::uniform_real_distribution<double> any(-1e3, 1e3);
  std::vector<double> values(recording.module.t_s.size());
  for (double& value : values) value = any(random);
  recording.module.channels = {{"deflection_rad", values}, {"current_a", values}};
  recording.loadcell.channels.push_back(
      {"force_n", std::vector<double>(recording.loadcell.t_s.size(), 1.0 / 3.0)});
  recording.gear_ratio = 349.0;
  recording.lever_arm_m = 0.1;
  recording.loadcell.host_latency = HostLatency{0.002, 1e-4};
  return recording;
}

std::string mcap_of(const Recording& recording) {
  std::string bytes;
  write_mcap(recording, {}, "searig test", [&](std::string_view piece) { bytes.append(piece); });
  return bytes;
}

void expect_same(const Stream& a, const Stream& b) {
  EXPECT_EQ(a.t_s, b.t_s);
  EXPECT_EQ(a.host_s, b.host_s);
  EXPECT_EQ(a.restarts, b.restarts);
  EXPECT_EQ(a.counts.received, b.counts.received);
  EXPECT_EQ(a.counts.lost, b.counts.lost);
  EXPECT_EQ(a.counts.doubled, b.counts.doubled);
  EXPECT_EQ(a.counts.garbled, b.counts.garbled);
  EXPECT_EQ(a.counts.out_of_order, b.counts.out_of_order);
  ASSERT_EQ(a.channels.size(), b.channels.size());
  for (std::size_t i = 0; i < a.channels.size(); ++i) {
    EXPECT_EQ(a.channels[i].name, b.channels[i].name);
    EXPECT_EQ(a.channels[i].values, b.channels[i].values);
  }
}

TEST(Import, AFolderReadsBackExactlyFromTheFile) {
  const TemporaryFolder folder;
  write_recording(a_recording(), folder.path());
  const Recording from_folder = read_recording(folder.path());
  EXPECT_GT(from_folder.loadcell.counts.lost, 10u);
  const auto file = folder.write("whole.mcap", mcap_of(from_folder));

  const Recording from_file = read_recording(file);
  expect_same(from_folder.module, from_file.module);
  expect_same(from_folder.loadcell, from_file.loadcell);
  EXPECT_EQ(from_file.gear_ratio, 349.0);
  EXPECT_EQ(from_file.lever_arm_m, 0.1);
  EXPECT_EQ(from_file.loadcell.host_latency->latency_s, 0.002);
  EXPECT_EQ(from_file.loadcell.host_latency->ci95_s, 1e-4);
  EXPECT_FALSE(from_file.one_clock);
  EXPECT_EQ(from_file.name, "whole");
  EXPECT_EQ(from_file.cut_off, "");
}

TEST(Import, KeepsRestartsOneClockAndTimesBelowZero) {
  Recording recording = a_recording();
  recording.one_clock = true;
  recording.module.host_s.clear();
  recording.loadcell.host_s.clear();
  for (double& t : recording.module.t_s) t -= 100.0;
  for (std::size_t i = 1000; i < recording.module.t_s.size(); ++i) recording.module.t_s[i] -= 4.0;
  recording.module.restarts = {1000};
  recording.model_toml = "format = \"searig-model/1\"\n";
  const Recording read = recording_of(mcap_of(recording), "file");
  expect_same(recording.module, read.module);
  expect_same(recording.loadcell, read.loadcell);
  EXPECT_TRUE(read.one_clock);
  EXPECT_EQ(read.model_toml, recording.model_toml);
}

TEST(Import, KeepsFurtherDevicesAndHowTheyAreAligned) {
  std::mt19937_64 random(2);
  Recording recording = a_recording();
  for (const AlignedBy how : {AlignedBy::host, AlignedBy::clock, AlignedBy::velocity}) {
    SimulatedDevice device;
    device.hz = 30.0;
    device.offset_s = 1e4;
    Device further{device.run(random, "device.encoder"), how};
    further.stream.name += std::to_string(int(how));
    further.stream.channels = {{"motor_angle_rad", further.stream.t_s}};
    if (how == AlignedBy::velocity) further.stream.host_s.clear();
    recording.devices.push_back(std::move(further));
  }
  recording.calibration = "# a line\ngain = 1.0\n";
  recording.recorded = "Recorded by hand.";
  const Recording read = recording_of(mcap_of(recording), "file");
  ASSERT_EQ(read.devices.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.devices[i].stream.name, recording.devices[i].stream.name);
    EXPECT_EQ(read.devices[i].aligned_by, recording.devices[i].aligned_by);
    expect_same(recording.devices[i].stream, read.devices[i].stream);
  }
  EXPECT_EQ(read.calibration, recording.calibration);
  EXPECT_EQ(read.recorded, recording.recorded);
}

TEST(Import, KeepsPings) {
  Recording recording = a_recording();
  recording.loadcell.restarts = {100};
  recording.loadcell.least_wire_s = 0.00137;
  for (int i = 0; i < 10; ++i)
    recording.loadcell.pings.push_back({i + 0.1, i + 7.0, i + 7.1, i + 0.3, std::size_t(i > 5)});
  const Recording read = recording_of(mcap_of(recording), "file");
  EXPECT_EQ(read.loadcell.least_wire_s, recording.loadcell.least_wire_s);
  EXPECT_TRUE(read.module.pings.empty());
  ASSERT_EQ(read.loadcell.pings.size(), 10u);
  for (std::size_t i = 0; i < 10; ++i) {
    const Exchange &a = read.loadcell.pings[i], &b = recording.loadcell.pings[i];
    EXPECT_EQ(
        std::tie(a.host_sent_s, a.device_received_s, a.device_sent_s, a.host_received_s, a.run),
        std::tie(b.host_sent_s, b.device_received_s, b.device_sent_s, b.host_received_s, b.run));
  }
}

TEST(Import, AModulesOwnLogNeedsNoLoadCell) {
  Recording recording = a_recording();
  recording.loadcell = {};
  const Recording read = recording_of(mcap_of(recording), "file");
  expect_same(recording.module, read.module);
  EXPECT_TRUE(read.loadcell.t_s.empty());
  EXPECT_EQ(synchronise(read).why, "there is no load cell.");
}

TEST(Import, KeepsTheOriginalsByteForByte) {
  const TemporaryFolder folder;
  write_recording(a_recording(), folder.path());
  folder.write("model.toml", "format = \"searig-model/1\"\n");
  const Recording recording = read_recording(folder.path());
  std::string bytes;
  write_mcap(recording, originals_of(recording), "searig test",
             [&](std::string_view piece) { bytes.append(piece); });
  struct Attached : Handler {
    std::map<std::string, std::string> files;
    void channel(const Channel&, const Schema&) override {}
    void message(const Message&) override {}
    void attachment(const Attachment& a) override { files[a.name] = a.data; }
  } attached;
  EXPECT_EQ(read(bytes, attached).end, End::whole);
  ASSERT_EQ(attached.files.size(), 4u);
  for (const auto& [name, text] : attached.files) {
    std::ostringstream original;
    original << std::ifstream(folder.path() / name).rdbuf();
    EXPECT_EQ(text, original.str()) << name;
  }
}

TEST(Import, RefusesWhatCouldNotBeRead) {
  Recording recording = a_recording();
  recording.module.channels[0].values[5] = HUGE_VAL;
  EXPECT_THROW(mcap_of(recording), std::invalid_argument);
  recording.module.channels[0].values.resize(5);
  EXPECT_THROW(mcap_of(recording), std::invalid_argument);
}

TEST(ReadMcap, SaysWhatIsNoRecording) {
  const TemporaryFolder folder;
  const auto why = [&](const std::string& text) {
    return refusal([&] { read_recording(folder.write("other.mcap", text)); });
  };
  EXPECT_TRUE(says(why("hello, this is text"), "other.mcap: is no MCAP file."));
  EXPECT_TRUE(says(why(""), "ends within its first bytes"));
  std::string empty;
  Writer([&](std::string_view piece) { empty.append(piece); }, "another").finish();
  EXPECT_TRUE(says(why(empty), "is an MCAP file, but no recording of searig's."));
}

}  // namespace
}  // namespace searig::acquisition::mcap
