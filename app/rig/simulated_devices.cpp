#include "app/rig/simulated_devices.h"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "acquisition/source/serial_source.h"
#include "acquisition/source/terminal_port.h"

namespace searig::app {
namespace {

using acquisition::Arrival;
using acquisition::Source;

constexpr unsigned baud = 115200;       // the firmware's
constexpr double until_they_run = 0.4;  // s; then both start at once

std::filesystem::path program(const char* name, const char* needs) {
  const auto path = acquisition::program_beside(name);
  if (std::filesystem::exists(path)) return path;
  throw std::runtime_error(std::string("There is no simulated rig, as ") + path.string() +
                           " was not built: " + needs + "; ./run installs what is missing.");
}

SimulatedDevice start(const std::filesystem::path& path, std::vector<std::string> arguments,
                      bool stepped, double start_s) {
  for (const char* always : {"--with-stdin", "--quiet"}) arguments.emplace_back(always);
  if (stepped)
    arguments.emplace_back("--stepped");
  else
    arguments.insert(arguments.end(), {"--start", std::to_string(start_s)});
  SimulatedDevice device{std::make_shared<acquisition::ChildProcess>(path, arguments), {}};
  device.address = device.process->hear();
  if (device.address.empty())
    throw std::runtime_error(path.string() + " ended as soon as it was started.");
  return device;
}

/// A source with the process that it listens to.
class Owned : public Source {
 public:
  Owned(SimulatedDevice device, std::unique_ptr<Source> source)
      : device_(std::move(device)), source_(std::move(source)) {}

  std::string name() const override { return "sim:" + source_->name(); }
  unsigned baud() const override { return source_->baud(); }
  int handle() const override { return source_->handle(); }
  double wake_s() const override { return source_->wake_s(); }
  void read(std::vector<Arrival>& arrivals) override { source_->read(arrivals); }
  void send(std::span<const std::uint8_t> bytes) override { source_->send(bytes); }
  const acquisition::SourceCounters& counters() const override { return source_->counters(); }

 private:
  SimulatedDevice device_;
  std::unique_ptr<Source> source_;
};

}  // namespace

/// A name under which the board is found again after it was unplugged, when its terminal is
/// another.
std::string link_for_board() {
  static std::atomic<int> boards{0};
  const auto name = "searig-board-" + std::to_string(getpid()) + "-" + std::to_string(++boards);
  return (std::filesystem::temp_directory_path() / name).string();
}

SimulatedDevice start_board(const DeviceOptions& options, bool stepped, double start_s) {
  const std::string link = link_for_board();
  SimulatedDevice board =
      start(program("searig-board", "it needs avr-gcc, the Arduino core for AVR and simavr"),
            {"--force", "twin:" + std::to_string(options.seed), "--skew-ppm",
             std::to_string(options.board_skew_ppm), "--link", link},
            stepped, start_s);
  board.address = link;
  return board;
}

SimulatedDevice start_module(const DeviceOptions& options, bool stepped, double start_s) {
  return start(program("searig-module", "it belongs to every build"),
               {"--port", "0", "--seed", std::to_string(options.seed), "--rate",
                std::to_string(options.module_rate_hz), "--skew-ppm",
                std::to_string(options.module_skew_ppm)},
               stepped, start_s);
}

std::unique_ptr<Source> open_board(const SimulatedDevice& board) {
  return std::make_unique<acquisition::SerialSource>(std::make_unique<acquisition::TerminalPort>(),
                                                     board.address, baud);
}

std::unique_ptr<Source> open_module(const SimulatedDevice& module) {
  return acquisition::open_source(module.address);
}

SimulatedSources simulated_sources(bool module, bool loadcell, const DeviceOptions& options) {
  const double start_s = acquisition::host_now_s() + until_they_run;
  SimulatedSources sources;
  if (loadcell) {
    SimulatedDevice board = start_board(options, false, start_s);
    auto source = open_board(board);
    sources.board_process = board.process;
    sources.loadcell = std::make_unique<Owned>(std::move(board), std::move(source));
  }
  if (module) {
    SimulatedDevice process = start_module(options, false, start_s);
    auto source = open_module(process);
    sources.module_process = process.process;
    sources.module = std::make_unique<Owned>(std::move(process), std::move(source));
  }
  std::this_thread::sleep_for(
      std::chrono::duration<double>(start_s - acquisition::host_now_s() - 0.01));
  return sources;
}

SimulatedSources open_rig(const std::string& module, const std::string& loadcell,
                          const DeviceOptions& options) {
  // Real ones first: a name that makes no sense is said at once.
  SimulatedSources real;
  if (module != simulated) real.module = acquisition::open_source(module);
  if (loadcell != simulated) real.loadcell = acquisition::open_source(loadcell);
  if (real.module && real.loadcell) return real;
  SimulatedSources rig = simulated_sources(!real.module, !real.loadcell, options);
  if (real.module) rig.module = std::move(real.module);
  if (real.loadcell) rig.loadcell = std::move(real.loadcell);
  return rig;
}

}  // namespace searig::app
