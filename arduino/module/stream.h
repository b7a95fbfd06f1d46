// The simulated module in real time on its link, with faults on command.
#pragma once

#include <deque>
#include <string_view>

#include "acquisition/wire/line_faults.h"
#include "arduino/line/commands.h"
#include "arduino/module/link.h"
#include "arduino/module/simulated_module.h"

namespace searig::module {

class Stream {
 public:
  /// start_s: the host's monotonic time at which the module's true time begins.
  Stream(SimulatedModule& module, Link& link, std::uint64_t seed, double start_s);

  /// Takes what the host has sent until now. Before the time is asked for, so that nothing is
  /// received before it was sent.
  void hear();

  /// Answers what was heard and sends what is due.
  void run_until(double host_s);
  double next_s() const { return start_s_ + module_.next_sample_s(); }

  /// drop SHARE, double SHARE, flip SHARE, stall SECONDS, reset, unplug, plug; and datagrams that
  /// do not belong: foreign N, replay N, long N, garbage N. Whether it is one.
  bool obey(const line::Command& command, double host_s);

  const acquisition::LineFaults& faults() const { return faults_; }
  std::uint64_t sent() const { return sent_; }

 private:
  using Bytes = std::vector<std::uint8_t>;
  void send(const Bytes& frame);
  void flush(double host_s);
  bool disturb(std::string_view word, std::size_t count);

  SimulatedModule& module_;
  Link& link_;
  acquisition::LineFaults faults_;
  double start_s_;
  double stalled_until_s_ = 0.0;
  std::deque<Bytes> heard_;
  std::deque<Bytes> held_;  ///< by a stall
  std::deque<Bytes> past_;  ///< the last frames, to be replayed
  std::uint64_t sent_ = 0;
};

}  // namespace searig::module
