// The simulated board on its bench: in real time, on a pseudo terminal, with faults on command.
#pragma once

#include <deque>
#include <vector>

#include "acquisition/wire/line_faults.h"
#include "arduino/board/simulated_board.h"
#include "arduino/line/commands.h"
#include "arduino/line/pseudo_terminal.h"

namespace searig::board {

class Bench {
 public:
  /// start_s: the host's monotonic time at which the board's time begins.
  Bench(SimulatedBoard& board, line::PseudoTerminal& terminal, std::uint64_t seed, double start_s);

  /// Takes what the host has sent until now. Before the time is asked for, so that nothing reaches
  /// the board before it was sent.
  void hear();

  /// Brings the board up to a monotonic time, gives it what was heard, and carries to the host what
  /// is due.
  void run_until(double host_s);

  /// drop SHARE, double SHARE, flip SHARE, stall SECONDS, hold NEWTON (in place of the motion),
  /// release, reset, unplug, plug. Whether it is one.
  bool obey(const line::Command& command, double host_s);

  const acquisition::LineFaults& faults() const { return faults_; }

 private:
  void collect();
  void deliver(double host_s);

  struct Frame {
    std::vector<std::uint8_t> bytes;
    double true_s;  ///< when its last byte was out
  };

  SimulatedBoard& board_;
  line::PseudoTerminal& terminal_;
  acquisition::LineFaults faults_;
  double start_s_;
  double stalled_until_s_ = 0.0;  ///< host time
  std::vector<std::uint8_t> heard_;
  std::vector<std::uint8_t> unended_;  ///< of the frame that is being sent
  std::deque<Frame> on_the_way_;
};

}  // namespace searig::board
