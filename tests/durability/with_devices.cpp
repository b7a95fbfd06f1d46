// searig record on the simulated devices, each a process of its own: real firmware, real
// libserialport.
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "acquisition/clock/synchronise.h"
#include "tests/arduino/device_processes.h"
#include "tests/system/running_record.h"

namespace searig {
namespace {

namespace fs = std::filesystem;

/// The shim lets libserialport take a pseudo terminal for a port (docs/rig.md).
std::vector<std::string> record_words(const BoardProcess& board, const std::string& module,
                                      const fs::path& out, double seconds) {
  const std::string bin = SEARIG_BINARY_DIR;
  return {"/usr/bin/env",  "LD_PRELOAD=" + bin + "/tests/acquisition/source/libsearig_pty_shim.so",
          bin + "/searig", "record",
          "--loadcell",    "serial:" + board.path,
          "--module",      module,
          "--lever-arm",   "0.15",
          "--seconds",     std::to_string(seconds),
          "--out",         out.string()};
}

double memory_kb(pid_t id) {
  std::ifstream status("/proc/" + std::to_string(id) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6));
  return 0.0;
}

double child_cpu_s() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

TEST(Durability, TenMinutesAtOneKilohertzLoseNothingAndCostLittle) {
  const TemporaryFolder folder;
  const BoardProcess board((folder.path() / "port").string());
  const ModuleProcess module({"--rate", "1000"});
  constexpr double seconds = 600.0;
  const fs::path file = folder.path() / "a.mcap";
  Running running(record_words(board, module.name, file, seconds));
  sleep_s(0.7 * seconds);
  const double memory_then = memory_kb(running.id());
  sleep_s(0.25 * seconds);
  const double memory_late = memory_kb(running.id());
  const double cpu_before_s = child_cpu_s();
  EXPECT_EQ(running.wait(), 0);
  const double share = (child_cpu_s() - cpu_before_s) / seconds;

  const auto recording = acquisition::read_recording(file);
  std::printf(
      "module %zu (lost %zu), load cell %zu (lost %zu), %.1f %% of a core, memory %.1f MB "
      "after 7 min, %.1f MB after 9.5 min, file %.0f MB\n",
      recording.module.t_s.size(), recording.module.counts.lost, recording.loadcell.t_s.size(),
      recording.loadcell.counts.lost, 100.0 * share, 1e-3 * memory_then, 1e-3 * memory_late,
      1e-6 * double(fs::file_size(file)));
  EXPECT_GT(recording.module.t_s.size(), 595'000u);
  EXPECT_GT(recording.loadcell.t_s.size(), 29'700u);
  for (const auto* stream : {&recording.module, &recording.loadcell}) {
    EXPECT_EQ(stream->counts.lost, 0u);
    EXPECT_EQ(stream->counts.garbled, 0u);
  }
  EXPECT_LT(share, 0.10);
  EXPECT_LT(memory_late, 1.1 * memory_then);
}

/// The truth is known since both start at one instant: what each clock shows is skew and offset.
TEST(Durability, PingsPlaceTheBoardOnTheModulesClockWithinAMillisecond) {
  const TemporaryFolder folder;
  const double start_s = acquisition::host_now_s() + 0.5;
  const std::vector<std::string> at{"--start", std::to_string(start_s)};
  std::vector<std::string> board_options{"--skew-ppm", "-2000"};
  board_options.insert(board_options.end(), at.begin(), at.end());
  const BoardProcess board((folder.path() / "port").string(), board_options);
  const ModuleProcess module(at);  // 14 ppm fast, 437.5 s ahead
  const fs::path file = folder.path() / "a.mcap";
  Running running(record_words(board, module.name, file, 30.0));
  EXPECT_EQ(running.wait(), 0);
  const auto recording = acquisition::read_recording(file);
  const acquisition::ClockMap map = acquisition::synchronise(recording);
  const double true_s = 15.0, boots_s = 145e-6;  // of the firmware, as a test of it measures
  const double error_s =
      map.to_module(true_s * (1.0 - 2000e-6) - boots_s) - (437.5 + true_s * (1.0 + 14e-6));
  std::printf("offset wrong by %.3f ms, stated +-%.3f ms: %s\n", 1e3 * error_s, 1e3 * map.ci95_s,
              map.why.c_str());
  EXPECT_TRUE(map.trusted);
  EXPECT_LT(std::abs(error_s), 1e-3);
  EXPECT_LE(std::abs(error_s), map.ci95_s);
  EXPECT_LT(map.ci95_s, 1e-3);
}

TEST(Durability, EverythingThatBefallsTheDevicesIsInOneRecording) {
  const TemporaryFolder folder;
  BoardProcess board((folder.path() / "port").string(), {"--force", "constant:10"});
  // Its 32 bits of microseconds are full after seven seconds.
  auto module = std::make_unique<ModuleProcess>(std::vector<std::string>{"--clock", "4288"});
  const std::string name = module->name, port = name.substr(name.rfind(':') + 1);
  const fs::path file = folder.path() / "a.mcap";
  Running running(record_words(board, name, file, 22.0));
  sleep_s(3.0);
  EXPECT_EQ(board.command("unplug"), "ok");
  sleep_s(3.0);
  EXPECT_EQ(board.command("plug"), "ok");
  sleep_s(3.0);
  EXPECT_EQ(board.command("reset"), "ok");
  sleep_s(3.0);
  module.reset();  // the module's process ends, and another begins
  const Process another({"searig-module", "--with-stdin", "--port", port});
  EXPECT_EQ(board.command("drop 0.01"), "ok");
  EXPECT_EQ(board.command("flip 0.001"), "ok");
  EXPECT_EQ(running.wait(), 0);

  const Ran info = run_program("searig info " + file.string() + " --json -");
  ASSERT_EQ(info.exit_code, 0) << info.err;
  std::set<std::string> kinds;
  const auto answer = nlohmann::json::parse(info.out);
  for (const auto& event : answer["events"])
    kinds.insert(event["device"].get<std::string>() + " " + event["kind"].get<std::string>());
  for (const char* kind :
       {"loadcell connected", "loadcell unplugged", "loadcell reconnected", "loadcell reset",
        "loadcell lost", "loadcell garbled", "module wrap", "module reset"})
    EXPECT_TRUE(kinds.contains(kind)) << kind;

  const auto recording = acquisition::read_recording(file);
  EXPECT_GE(recording.loadcell.restarts.size(), 1u);
  const auto& force_n = recording.loadcell.channel("force_n");
  EXPECT_GT(force_n.size(), 600u);
  for (const double force : force_n) ASSERT_NEAR(force, 10.0, 0.01);
}

}  // namespace
}  // namespace searig
