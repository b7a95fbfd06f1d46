// Commands to a simulated device: lines on its standard input, each answered on standard output.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "acquisition/wire/line_faults.h"

namespace searig::line {

/// "unplug", or with a number from 0 up: "drop 0.01".
struct Command {
  std::string_view word;
  std::optional<double> number;
};

class CommandLine {
 public:
  /// Whether it understood the command.
  using Handler = std::function<bool(const Command&)>;

  explicit CommandLine(Handler handler) : handler_(std::move(handler)) {}

  /// To be polled, or -1 after the end.
  int handle() const;
  bool ended() const { return ended_; }

  /// Reads what is there, carries out whole lines, says "ok" or "error: WHY" to each.
  void read();

  /// Carries out one line; empty, or why not.
  std::string obey(std::string_view line) const;

 private:
  Handler handler_;
  std::string unread_;
  bool ended_ = false;
};

/// Who owns a simulated device's time: the machine's clock, or whoever says "run SECONDS".
class DeviceTime {
 public:
  /// start_s: the monotonic time at which the device starts; stepped: its time stands at 0 there
  /// and moves only when told to.
  DeviceTime(double start_s, bool stepped) : start_s_(stepped ? 0.0 : start_s), stepped_(stepped) {}

  double start_s() const { return start_s_; }
  double now_s() const;
  bool stepped() const { return stepped_; }

  /// "run SECONDS": up to so long after the start. Whether it is that command and time is stepped.
  bool obey(const Command& command);

 private:
  double start_s_;
  bool stepped_;
  double reached_s_ = 0.0;
};

/// What a device does with commands: its time moves it on, once it has heard what waited until
/// then; all others it obeys itself.
template <typename Device>
CommandLine::Handler commands_to(Device& device, DeviceTime& time) {
  return [&](const Command& command) {
    const double before_s = time.now_s();
    if (!time.obey(command)) return device.obey(command, before_s);
    device.hear();
    device.run_until(before_s);
    device.run_until(time.now_s());
    return true;
  };
}

/// The faults that all links have: drop, double and flip with their shares.
bool set_fault(acquisition::FaultShares& shares, const Command& command);

}  // namespace searig::line
