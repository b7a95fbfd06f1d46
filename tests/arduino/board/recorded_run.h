// The real firmware and a module, heard over ways that nobody knows, pinged and recorded as a
// recorder does it; all in simulated time. What `searig sync` then makes of the file.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recorder/device_stream.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "acquisition/wire/encode.h"
#include "arduino/module/simulated_module.h"
#include "tests/arduino/board/board_run.h"

namespace searig::board {

struct RecordedRun {
  acquisition::ClockMap map;
  double error_s = 0.0;  ///< of the load cell's time on the module's clock, at the middle
};

/// A way with a fixed part, jitter, and stalls; nothing overtakes.
class Way {
 public:
  Way(double fixed_s, double jitter_s) : fixed_s_(fixed_s), jitter_s_(jitter_s) {}
  double arrival(double sent_s, std::mt19937_64& random) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    double late_s = fixed_s_ + std::exponential_distribution<double>(1.0 / jitter_s_)(random);
    if (share(random) < 0.002) late_s += 0.06 * share(random);
    return last_s_ = std::max(last_s_ + 1e-6, sent_s + late_s);
  }

 private:
  double fixed_s_, jitter_s_, last_s_ = 0.0;
};

inline RecordedRun record_firmware(unsigned seed, double seconds) {
  using namespace acquisition;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  BoardSettings settings;
  settings.firmware = firmware("hx711");
  settings.skew_ppm = 4000.0 * (share(random) - 0.5);
  settings.last_boot = static_cast<std::uint16_t>(seed);
  SimulatedBoard board(settings, [](double t) { return 20.0 * std::sin(t); });
  const module::ModuleSettings module_settings{.rate_hz = 200.0,
                                               .skew_ppm = 100.0 * (share(random) - 0.5),
                                               .clock_s = 4290.0 * share(random),
                                               .seed = seed};
  module::SimulatedModule module(module_settings);
  Way to_board(4e-4 * share(random), 3e-4), from_board(4e-4 * share(random), 8e-4);
  Way to_module(2e-4 * share(random), 1e-4), from_module(2e-4 * share(random), 2e-4);

  DeviceStream loadcells(StreamId::loadcell, Framing::stream, CountsToForce{84000.0, 5e-4});
  DeviceStream modules(StreamId::module, Framing::datagrams);
  std::multimap<double, std::pair<StreamId, std::vector<std::uint8_t>>> on_the_way;
  const double host_s = 1000.0;  // what the host's clock shows at the start
  double ping_s = 0.2;
  std::uint32_t pings = 0;
  for (double until_s = 0.05; until_s <= seconds; until_s += 0.05) {
    if (until_s > ping_s) {
      const double asked_s = until_s - 0.05 * share(random);
      ping_s += 0.5;
      board.run_until(to_board.arrival(asked_s, random));
      board.receive(ping_frame(pings, host_s + asked_s));
      const double there_s = to_module.arrival(asked_s, random);
      on_the_way.emplace(from_module.arrival(there_s, random),
                         std::pair{StreamId::module,
                                   module.answer(ping_frame(pings++, host_s + asked_s), there_s)});
    }
    board.run_until(until_s);
    std::vector<std::uint8_t> frame;
    for (const auto& [byte, true_s] : board.take_sent())
      on_the_way.emplace(from_board.arrival(true_s, random),
                         std::pair{StreamId::loadcell, std::vector{byte}});
    while (module.next_sample_s() < until_s) {
      const double true_s = module.next_sample_s();
      on_the_way.emplace(from_module.arrival(true_s, random),
                         std::pair{StreamId::module, module.take_sample()});
    }
  }
  std::string file;
  mcap::RecordingWriter out([&](std::string_view piece) { file.append(piece); }, "test", 0.0);
  mcap::Settings recorded;
  recorded.loadcell.baud = 115200;
  out.settings(recorded, host_s);
  std::vector<Entry> entries;
  for (const auto& [at_s, bytes] : on_the_way)
    (bytes.first == StreamId::module ? modules : loadcells)
        .take({Arrival::Kind::bytes, host_s + at_s, bytes.second, {}}, entries);
  for (const Entry& entry : entries) write_entry(entry, out);
  out.file().finish();

  RecordedRun run{synchronise(mcap::recording_of(file, "run")), 0.0};
  const double true_s = 0.5 * seconds, boots_s = 145e-6;  // which a test of the stamps measures
  const double loadcell_s = true_s * (1.0 + settings.skew_ppm * 1e-6) - boots_s;
  const double module_s =
      module_settings.clock_s + true_s * (1.0 + module_settings.skew_ppm * 1e-6);
  run.error_s = run.map.to_module(loadcell_s) - module_s;
  return run;
}

/// Holds a number of seeded runs against the bounds, and prints their figures.
inline void expect_within_a_millisecond(unsigned runs, double seconds) {
  unsigned covered = 0;
  double worst = 0.0, widest = 0.0;
  for (unsigned seed = 1; seed <= runs; ++seed) {
    const RecordedRun run = record_firmware(seed, seconds);
    EXPECT_TRUE(run.map.trusted) << run.map.why;
    covered += std::abs(run.error_s) <= run.map.ci95_s;
    worst = std::max(worst, std::abs(run.error_s));
    widest = std::max(widest, run.map.ci95_s);
  }
  std::printf("firmware, %u runs: worst error %.3f ms, widest interval +-%.3f ms, covered %u\n",
              runs, 1e3 * worst, 1e3 * widest, covered);
  EXPECT_LT(worst, 1e-3);
  EXPECT_LT(widest, 1.5e-3);  // and not by saying nothing
  EXPECT_GE(covered, 0.95 * runs);
}

}  // namespace searig::board
