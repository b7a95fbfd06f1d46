// searig-board: an Arduino with a load cell that is not there, for the host's real serial path.
// Links simavr, so this program is under the GPL (LICENSE).
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <iostream>
#include <random>

#include "acquisition/error.h"
#include "acquisition/source/source.h"
#include "acquisition/wire/encode.h"
#include "arduino/board/bench.h"
#include "arduino/board/force.h"

namespace {

using searig::acquisition::host_now_s;
using searig::acquisition::InputError;
using searig::board::Bench;
using searig::board::SimulatedBoard;
using searig::line::DeviceTime;

volatile sig_atomic_t stopped = 0;

struct Options {
  std::string sensor = "hx711", link, force = "sine:20,0.5", eeprom;
  searig::board::BoardSettings board;
  std::uint64_t seed = 1;
  double epoch_s = NAN, start_s = NAN, seconds = INFINITY;
  bool uncalibrated = false, with_stdin = false, stepped = false, quiet = false;
};

int parse(int argc, char** argv, Options& options) {
  CLI::App app{
      "A simulated Arduino with a load cell: runs the real firmware on a pseudo terminal.\n"
      "Commands on standard input: drop SHARE, double SHARE, flip SHARE (of bits),\n"
      "stall SECONDS, hold NEWTON (in place of the motion), release, reset, unplug, plug.\n"
      "Each is answered by 'ok' or 'error: WHY'."};
  app.footer("Example:\n  searig-board --link /tmp/loadcell --force sine:20,0.5 --skew-ppm -2000");
  app.add_option("--sensor", options.sensor, "hx711 or analogue")
      ->check(CLI::IsMember({"hx711", "analogue"}))
      ->capture_default_str();
  app.add_option("--firmware", options.board.firmware, "another ELF than the one built here");
  app.add_option("--link", options.link, "a symbolic link to the terminal while plugged in");
  app.add_option("--force", options.force, "constant:N, sine:N,HZ[,N], ramp:N_PER_S, twin[:SEED]")
      ->capture_default_str();
  app.add_option("--epoch", options.epoch_s,
                 "when the force's time is 0, on the monotonic clock; else the start");
  app.add_option("--start", options.start_s, "when it starts, on the monotonic clock; else now");
  app.add_option("--skew-ppm", options.board.skew_ppm, "how much too fast the board's clock is");
  app.add_option("--hx711-hz", options.board.hx711_hz, "conversions in a second")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "of the faults")->capture_default_str();
  app.add_option("--eeprom", options.eeprom, "a file that keeps the board's memory between runs");
  app.add_option("--seconds", options.seconds, "ends after this time");
  app.add_flag("--uncalibrated", options.uncalibrated, "tare and gain are not stored in the board");
  app.add_flag("--with-stdin", options.with_stdin, "ends when standard input ends");
  app.add_flag("--stepped", options.stepped,
               "its time moves only by the command 'run SECONDS', to so long after the start");
  app.add_flag("--quiet", options.quiet, "says nothing at its end");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (options.board.firmware.empty()) {
    options.board.firmware = SEARIG_FIRMWARE_DIR "/loadcell-" + options.sensor + ".elf";
  }
  return -1;
}

/// Someone has calibrated it once, through the firmware's own request.
void calibrate(SimulatedBoard& board, const Options& options) {
  const auto& set = options.board;
  const double gain = options.sensor == "hx711" ? 1.0 / set.counts_per_newton
                                                : 5000.0 / (16 * 1023 * set.mv_per_newton);
  const double rest = options.sensor == "hx711" ? set.counts_at_rest : 16 * 511;
  board.run_until(0.1);
  board.receive(searig::acquisition::calibration_frame(static_cast<std::int32_t>(std::lround(rest)),
                                                       static_cast<float>(gain)));
}

bool load_eeprom(SimulatedBoard& board, const std::string& file) {
  SimulatedBoard::Eeprom bytes;
  std::ifstream in(file, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(bytes.data()), bytes.size())) return false;
  board.set_eeprom(bytes);
  return true;
}

void save_eeprom(const SimulatedBoard& board, const std::string& file) {
  const auto bytes = board.eeprom();
  std::ofstream out(file, std::ios::binary);
  if (!out.write(reinterpret_cast<const char*>(bytes.data()), bytes.size()).flush()) {
    throw InputError(file + " cannot be written");
  }
}

/// Until stopped, in steps of a fifth of a millisecond; after a stall it catches up.
void run(Bench& bench, const searig::line::PseudoTerminal& terminal, DeviceTime& time,
         const Options& options) {
  searig::line::CommandLine commands(searig::line::commands_to(bench, time));
  const double end_s = time.now_s() + options.seconds;
  while (!stopped && time.now_s() < end_s && !(options.with_stdin && commands.ended())) {
    pollfd ready[] = {{commands.handle(), POLLIN, 0}};
    const timespec step{0, 200'000};
    if (ppoll(ready, 1, time.stepped() ? nullptr : &step, nullptr) > 0) commands.read();
    if (time.stepped()) continue;
    bench.hear();
    bench.run_until(time.now_s());
  }
  if (options.quiet) return;
  std::cerr << "searig-board: " << bench.faults().dropped() << " frames dropped, "
            << bench.faults().duplicated() << " doubled, " << bench.faults().damaged()
            << " damaged; " << terminal.lost() << " bytes found the terminal full\n";
}

int simulate(Options& options) {
  // A new board has started any number of times before, so that a host tells it from the last one.
  options.board.last_boot = static_cast<std::uint16_t>(std::random_device{}());
  constexpr double kBefore = 0.3;  // s of calibration
  DeviceTime time(std::isnan(options.start_s) ? host_now_s() : options.start_s, options.stepped);
  const double epoch_s = std::isnan(options.epoch_s) ? time.start_s() : options.epoch_s;
  const double start_s = time.start_s() - kBefore, begin_s = start_s - epoch_s;
  SimulatedBoard board(options.board, searig::board::parse_force(options.force, begin_s));
  if (options.eeprom.empty() || !load_eeprom(board, options.eeprom)) {
    if (!options.uncalibrated) calibrate(board, options);
  }
  board.run_until(kBefore);
  board.reset();
  board.take_sent();
  searig::line::PseudoTerminal terminal(options.link);
  terminal.plug();
  std::cout << terminal.path() << std::endl;
  Bench bench(board, terminal, options.seed, start_s);
  run(bench, terminal, time, options);
  if (!options.eeprom.empty()) save_eeprom(board, options.eeprom);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  if (const int code = parse(argc, argv, options); code >= 0) return code;
  struct sigaction stop {};
  stop.sa_handler = [](int) { stopped = 1; };
  sigaction(SIGTERM, &stop, nullptr);
  sigaction(SIGINT, &stop, nullptr);
  signal(SIGPIPE, SIG_IGN);
  try {
    return simulate(options);
  } catch (const InputError& error) {
    std::cerr << "searig-board: " << error.what() << '\n';
    return 1;
  }
}
