#include "arduino/board/bench.h"

#include <utility>

namespace searig::board {

Bench::Bench(SimulatedBoard& board, line::PseudoTerminal& terminal, std::uint64_t seed,
             double start_s)
    : board_(board), terminal_(terminal), faults_(seed), start_s_(start_s) {}

void Bench::hear() {
  heard_ = terminal_.read();
}

void Bench::run_until(double host_s) {
  board_.run_until(host_s - start_s_);
  board_.receive(std::exchange(heard_, {}));
  collect();
  deliver(host_s);
}

/// Faults befall whole frames.
void Bench::collect() {
  for (const auto& [byte, true_s] : board_.take_sent()) {
    unended_.push_back(byte);
    if (byte != 0) continue;
    on_the_way_.push_back({faults_.pass(unended_), true_s});
    unended_.clear();
  }
}

void Bench::deliver(double host_s) {
  if (host_s < stalled_until_s_) return;
  while (!on_the_way_.empty() && start_s_ + on_the_way_.front().true_s <= host_s) {
    terminal_.write(on_the_way_.front().bytes);
    on_the_way_.pop_front();
  }
}

bool Bench::obey(const line::Command& command, double host_s) {
  if (line::set_fault(faults_.shares, command)) return true;
  if (command.word == "stall" && command.number) {
    stalled_until_s_ = host_s + *command.number;
    return true;
  }
  if (command.word == "hold" && command.number) {
    board_.hold(*command.number);
    return true;
  }
  if (command.number) return false;
  if (command.word == "reset") {
    board_.reset();
  } else if (command.word == "release") {
    board_.hold({});
  } else if (command.word == "unplug") {
    terminal_.unplug();
  } else if (command.word == "plug") {
    terminal_.plug();
  } else {
    return false;
  }
  return true;
}

}  // namespace searig::board
