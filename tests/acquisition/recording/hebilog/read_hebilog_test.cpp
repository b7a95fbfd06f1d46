#include "acquisition/recording/hebilog/read_hebilog.h"

#include <gtest/gtest.h>

#include <random>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/csv.h"
#include "tests/acquisition/recording/hebilog/a_log.h"
#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition::hebilog {
namespace {

namespace fs = std::filesystem;

Recording read(const std::string& bytes) {
  return recording_of(bytes, std::nullopt);
}

TEST(Hebilog, GivesEveryChannelInSiUnitsAndSearigsSigns) {
  const Recording log = read(a_log(100));
  const Stream& module = log.module;
  ASSERT_EQ(module.t_s.size(), 100u);
  EXPECT_EQ(module.counts.lost + module.counts.garbled + module.counts.doubled, 0u);
  EXPECT_EQ(module.t_s[7], (4000090 + 70000) / 1e6);
  EXPECT_EQ(module.host_s[7], 1500000000071000 / 1e6);
  EXPECT_EQ(module.channel("seq")[7], 8.0);
  EXPECT_EQ(module.channel("output_angle_rad")[7], double(0.07f));
  EXPECT_EQ(module.channel("effort_nm")[7], double(-4.0f * 0.07f));
  EXPECT_EQ(module.channel("deflection_rad")[7], -double(0.1f * 0.07f));
  EXPECT_EQ(module.channel("input_angle_rad")[7], double(0.07f) - double(0.1f * 0.07f));
  EXPECT_EQ(module.channel("current_a")[7], 0.5);
  EXPECT_EQ(module.channel("voltage_v")[7], 24.5);
  EXPECT_EQ(module.channel("field_14_3")[7], -2.0);  // of unknown meaning, kept all the same
  EXPECT_EQ(log.recorded,
            "Recorded 2017-07-14T02:40:00Z by a HEBI module (X5-1, X-00007, Arm/Wrist).");
  EXPECT_TRUE(log.loadcell.t_s.empty());
  EXPECT_TRUE(log.events.empty());
}

TEST(Hebilog, WhatNotEveryFeedbackHasIsAStreamOfItsOwn) {
  const Recording log = read(a_log(100));
  ASSERT_EQ(log.devices.size(), 1u);
  const Stream& command = log.devices[0].stream;
  EXPECT_EQ(command.name, "device.command");
  EXPECT_EQ(log.devices[0].aligned_by, AlignedBy::clock);
  ASSERT_EQ(command.t_s.size(), 95u);
  EXPECT_EQ(command.t_s[0], log.module.t_s[5]);
  EXPECT_EQ(command.channel("commanded_angle_rad")[0], double(0.01f * 5.0f));
  EXPECT_EQ(command.channel("commanded_velocity_rad_s")[0], 1.0);
}

TEST(Hebilog, HasTheFourTimesOfEveryFeedback) {
  const Recording log = read(a_log(100));
  ASSERT_EQ(log.module.pings.size(), 100u);
  const Exchange& ping = log.module.pings[3];
  EXPECT_EQ(ping.host_sent_s, 1500000000030100 / 1e6);
  EXPECT_EQ(ping.device_received_s, 4.03);
  EXPECT_EQ(ping.device_sent_s, 4030090 / 1e6);
  EXPECT_EQ(ping.host_received_s, 1500000000031000 / 1e6);
}

TEST(Hebilog, LosesAndDoublesAreCounted) {
  std::string bytes = header({one_address});
  for (const int i : {0, 1, 2, 3, 3, 4, 7, 6, 8, 9})
    bytes += frame(1, one_address, 1500000000001000 + 10000 * std::uint64_t(i), feedback(i));
  const StreamCounts counts = read(bytes).module.counts;
  EXPECT_EQ(counts.received, 9u);
  EXPECT_EQ(counts.doubled, 1u);
  EXPECT_EQ(counts.lost, 1u);
  EXPECT_EQ(counts.out_of_order, 1u);
}

TEST(Hebilog, OfSeveralModulesOneIsChosen) {
  std::string bytes = header({1, 2});
  for (int i = 0; i < 10; ++i)
    for (const std::uint64_t address : {1, 2})
      bytes += frame(1, address, 1000, feedback(i + int(address)));
  EXPECT_TRUE(
      says(refusal([&] { read(bytes); }), "of 2 modules, and a recording is of one; --module"));
  EXPECT_TRUE(says(refusal([&] { recording_of(bytes, 3); }), "there is no module 3"));
  EXPECT_EQ(recording_of(bytes, 2).module.channel("seq")[0], 3.0);
}

TEST(Hebilog, CutAnywhereItKeepsWhatIsWhole) {
  const std::string bytes = a_log(12);
  const Recording whole = read(bytes);
  std::size_t kept = 0;
  for (std::size_t size = bytes.size(); size-- > 600;) {
    const Recording cut = read(bytes.substr(0, size));
    kept = cut.module.t_s.size();
    ASSERT_TRUE(std::equal(cut.module.t_s.begin(), cut.module.t_s.end(), whole.module.t_s.begin()));
    ASSERT_LE(cut.events.size(), 1u);
    if (!cut.events.empty()) {
      ASSERT_TRUE(says(cut.events[0].text, "the log ends within a frame")) << cut.events[0].text;
    }
  }
  EXPECT_LE(kept, 5u);
  EXPECT_TRUE(says(refusal([&] { read(bytes.substr(0, 40)); }), "holds no feedback"));
}

TEST(Hebilog, DamagedItGoesOnBehindTheDamageAndSaysSo) {
  std::string bytes = a_log(100);
  const std::size_t second = bytes.find("\x73\xB1", 200);
  bytes[second + 13] = '\x7f';  // a length
  bytes.replace(bytes.size() / 2, 30, std::string(30, '\xff'));
  const Recording log = read(bytes);
  EXPECT_GE(log.module.t_s.size(), 96u);
  EXPECT_GE(log.module.counts.garbled, 2u);
  ASSERT_EQ(log.events.size(), 1u);
  EXPECT_TRUE(says(log.events[0].text, "the first at byte " + std::to_string(second)))
      << log.events[0].text;
}

TEST(Hebilog, NoBytesBringItDown) {
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes = a_log(6);
    for (int i = 0; i < 1 + round % 8; ++i) bytes[random() % bytes.size()] = char(random());
    try {
      const Recording log = read(bytes);
      ASSERT_LE(log.module.t_s.size(), 6u);
    } catch (const InputError&) {
    }
  }
}

TEST(Hebilog, MayBeTheModuleOfAFolderWithALoadCell) {
  const TemporaryFolder folder;
  folder.write("arm.hebilog", a_log(500));
  std::string loadcell = "t_s,host_s,torque_nm\n";
  for (int i = 0; i < 200; ++i)
    loadcell += std::to_string(0.02 * i) + "," + std::to_string(1500000000.5 + 0.02 * i) + ",1\n";
  folder.write("loadcell.csv", loadcell);
  folder.write("recording.toml",
               "format = \"searig-recording/1\"\n[module]\nfile = \"arm.hebilog\"\n"
               "gear_ratio = 272.0\n[loadcell]\nfile = \"loadcell.csv\"\n");
  const Recording recording = read_recording(folder.path());
  EXPECT_EQ(recording.module.t_s.size(), 500u);
  EXPECT_EQ(recording.gear_ratio, 272.0);
  ASSERT_EQ(recording.devices.size(), 1u);
  EXPECT_FALSE(recording.one_clock);
  EXPECT_NEAR(synchronise(recording).to_module(0.0), 4.5, 0.05);
}

/// HEBI's own log against what was decoded from it elsewhere (../shared/data, PROVENANCE.md).
TEST(Hebilog, ReadsTheRealLogAsItWasDecodedElsewhere) {
  const fs::path home = fs::path(SEARIG_SHARED_DIR) / "data/hebi_x5_log";
  if (!fs::exists(home)) GTEST_SKIP() << home << " is not there";
  const Recording log = read_hebilog(home / "exampleLog.hebilog");
  const CsvFile csv(home / "DERIVED_exampleLog_decoded.csv", true);
  const struct {
    const char* column;
    const char* channel;
    double factor = 1.0;
  } same[] = {{"seq", "seq"},
              {"voltage", "voltage_v"},
              {"temp4", "board_temperature_c"},
              {"pos", "output_angle_rad"},
              {"vel", "output_velocity_rad_s"},
              {"effort", "effort_nm"},
              {"defl", "deflection_rad", -1.0},
              {"motorVel", "motor_velocity_rad_s"},
              {"deflVel", "deflection_velocity_rad_s"},
              {"motorCur", "supply_current_a"},
              {"t8", "motor_sensor_temperature_c"},
              {"t9", "housing_temperature_c"},
              {"t10", "winding_temperature_c"},
              {"windCur", "current_a"},
              {"motorPos", "output_angle_in_turn_rad"},
              {"p4", "field_10_9_4"},
              {"p5", "field_10_9_5"}};
  const auto column = [&](const char* name) {
    const std::vector<std::size_t> number{csv.find(name)};
    return csv.read(number, Faults::count).columns[0];
  };
  ASSERT_EQ(log.module.t_s.size(), 1000u);
  for (const auto& [name, channel, factor] : same) {
    std::vector<double> values = column(name);
    for (double& value : values) value *= factor;
    EXPECT_EQ(log.module.channel(channel), values) << channel;
  }
  const std::vector<double> log_us = column("log_us"), sent_us = column("hwB_us"),
                            received_us = column("hwA_us"), host_us = column("pcTx_us");
  for (std::size_t row = 0; row < 1000; ++row) {
    EXPECT_EQ(log.module.t_s[row], sent_us[row] / 1e6);
    EXPECT_EQ(log.module.host_s[row], log_us[row] / 1e6);
    EXPECT_EQ(log.module.pings[row].device_received_s, received_us[row] / 1e6);
    EXPECT_EQ(log.module.pings[row].host_sent_s, host_us[row] / 1e6);
  }
  ASSERT_EQ(log.devices.size(), 1u);  // what the CSV calls cmdpos?, cmdv and pwm1
  EXPECT_EQ(log.devices[0].stream.channel("commanded_velocity_rad_s"), column("cmdpos?"));
  EXPECT_EQ(log.devices[0].stream.channel("commanded_angle_rad"), column("pwm1"));
  EXPECT_EQ(log.devices[0].stream.channel("commanded_effort_nm"), column("cmdv"));
  EXPECT_EQ(
      log.recorded,
      "Recorded 2018-07-05T20:06:00Z by a HEBI module (X5-1, X-00131, My Family/Test Module).");
}

}  // namespace
}  // namespace searig::acquisition::hebilog
