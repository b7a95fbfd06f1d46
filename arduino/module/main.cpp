// searig-module: an actuator module that is not there, streaming the twin from a process of its
// own.
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "acquisition/error.h"
#include "acquisition/source/source.h"
#include "arduino/module/stream.h"

namespace {

using searig::acquisition::host_now_s;
using searig::acquisition::InputError;
using searig::line::DeviceTime;

volatile sig_atomic_t stopped = 0;

struct Options {
  searig::module::ModuleSettings module;
  std::string host = "127.0.0.1", serial;
  std::uint16_t port = 5005;
  std::uint64_t fault_seed = 1;
  double epoch_s = NAN, start_s = NAN, seconds = INFINITY;
  bool with_stdin = false, stepped = false, quiet = false;
};

int parse(int argc, char** argv, Options& options) {
  CLI::App app{
      "A simulated module: streams spring angles and current as frames over UDP or serial.\n"
      "Commands on standard input: drop SHARE, double SHARE, flip SHARE (of bits),\n"
      "stall SECONDS, reset, unplug, plug, foreign N, replay N, long N, garbage N.\n"
      "Each is answered by 'ok' or 'error: WHY'."};
  app.footer("Example:\n  searig-module --port 5005 --rate 1000");
  app.add_option("--host", options.host, "address to listen at")->capture_default_str();
  app.add_option("--port", options.port, "UDP port to listen at; 0: any")->capture_default_str();
  app.add_option("--serial", options.serial, "a pseudo terminal under this link, instead of UDP");
  app.add_option("--rate", options.module.rate_hz, "samples in a second")
      ->check(CLI::Range(1.0, 5000.0))
      ->capture_default_str();
  app.add_option("--skew-ppm", options.module.skew_ppm, "how much too fast its clock is")
      ->capture_default_str();
  app.add_option("--clock", options.module.clock_s, "what its clock shows at the start, s")
      ->capture_default_str();
  app.add_option("--seed", options.module.seed, "of the experiment")->capture_default_str();
  app.add_option("--fault-seed", options.fault_seed, "of the faults")->capture_default_str();
  app.add_option("--epoch", options.epoch_s,
                 "when the experiment's time is 0, on the monotonic clock; else the start");
  app.add_option("--start", options.start_s, "when it starts, on the monotonic clock; else now");
  app.add_option("--seconds", options.seconds, "ends after this time");
  app.add_flag("--with-stdin", options.with_stdin, "ends when standard input ends");
  app.add_flag("--stepped", options.stepped,
               "its time moves only by the command 'run SECONDS', to so long after the start");
  app.add_flag("--quiet", options.quiet, "says nothing at its end");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return -1;
}

void run(searig::module::Stream& stream, const searig::module::Link& link, DeviceTime& time,
         const Options& options) {
  searig::line::CommandLine commands(searig::line::commands_to(stream, time));
  const double end_s = time.now_s() + options.seconds;
  while (!stopped && time.now_s() < end_s && !(options.with_stdin && commands.ended())) {
    pollfd ready[] = {{commands.handle(), POLLIN, 0}, {link.handle(), POLLIN, 0}};
    const double wait_s = std::clamp(stream.next_s() - time.now_s(), 0.0, 0.01);
    const timespec wait{0, static_cast<long>(wait_s * 1e9)};
    const int watched = time.stepped() ? 1 : 2;
    if (ppoll(ready, watched, time.stepped() ? nullptr : &wait, nullptr) > 0 &&
        ready[0].revents != 0)
      commands.read();
    if (time.stepped()) continue;
    stream.hear();
    stream.run_until(time.now_s());
  }
  if (options.quiet) return;
  std::cerr << "searig-module: " << stream.sent() << " frames made, " << stream.faults().dropped()
            << " dropped, " << stream.faults().duplicated() << " doubled, "
            << stream.faults().damaged() << " damaged\n";
}

int simulate(Options& options) {
  DeviceTime time(std::isnan(options.start_s) ? host_now_s() : options.start_s, options.stepped);
  // A module has started any number of times before, so that a host tells it from the last one.
  options.module.boot = static_cast<std::uint16_t>(std::random_device{}());
  if (!std::isnan(options.epoch_s)) options.module.begin_s = time.start_s() - options.epoch_s;
  searig::module::SimulatedModule module(options.module);
  const auto link = options.serial.empty()
                        ? std::make_unique<searig::module::DatagramLink>(options.host, options.port)
                        : searig::module::make_serial_link(options.serial);
  std::cout << link->name() << std::endl;
  searig::module::Stream stream(module, *link, options.fault_seed, time.start_s());
  run(stream, *link, time, options);
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
    std::cerr << "searig-module: " << error.what() << '\n';
    return 1;
  }
}
