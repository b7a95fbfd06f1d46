// The two simulated devices as processes of their own: the real firmware on a simulated board, and
// a module, both at one and the same motion.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "acquisition/source/child_process.h"
#include "acquisition/source/source.h"
#include "app/rig/link.h"

namespace searig::app {

/// The name of a source that is simulated.
inline constexpr const char* simulated = "sim:";

struct DeviceOptions {
  std::uint64_t seed = 1;  ///< of the experiment: the same one is the same motion
  double module_rate_hz = 500.0;
  double module_skew_ppm = 14.0;   ///< the module's crystal is good
  double board_skew_ppm = -310.0;  ///< a ceramic resonator

  /// What the devices' clocks show, by true time since their start.
  DeviceClock module_clock() const { return {module_skew_ppm, 437.5}; }
  DeviceClock board_clock() const { return {board_skew_ppm, -145e-6}; }  ///< so long it boots
};

/// A device that runs while this object lives.
struct SimulatedDevice {
  std::shared_ptr<acquisition::ChildProcess> process;
  std::string address;  ///< where it is to be heard: a pseudo terminal, or udp:HOST:PORT
};

/// Both throw std::runtime_error with one sentence where the program is not there; the board's says
/// what it is built from. stepped: time moves by the command "run SECONDS" only (DeviceTime).
/// start_s: when the device starts, on the host's monotonic clock, where it is not stepped.
SimulatedDevice start_board(const DeviceOptions& options, bool stepped, double start_s);
SimulatedDevice start_module(const DeviceOptions& options, bool stepped, double start_s);

/// What a device says, through the host's usual ways: terminal and datagrams.
std::unique_ptr<acquisition::Source> open_board(const SimulatedDevice& board);
std::unique_ptr<acquisition::Source> open_module(const SimulatedDevice& module);

struct SimulatedSources {
  std::unique_ptr<acquisition::Source> module;
  std::unique_ptr<acquisition::Source> loadcell;
  /// The processes behind them, for commands ("unplug", "hold 19.6"); null where there is none.
  std::shared_ptr<acquisition::ChildProcess> module_process, board_process;
};

/// Devices in real time, which end with their sources; each is only started if it is wanted.
SimulatedSources simulated_sources(bool module, bool loadcell, const DeviceOptions& options = {});

/// The sources of a rig by their names: "sim:" is simulated, the rest as acquisition::open_source
/// has it. Simulated devices share one motion; a real device beside a simulated one is taken as it
/// is. Throws with one sentence.
SimulatedSources open_rig(const std::string& module, const std::string& loadcell,
                          const DeviceOptions& options = {});

}  // namespace searig::app
