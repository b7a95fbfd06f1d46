#include "arduino/board/bench.h"

#include <charconv>

namespace searig::board {

Bench::Bench(SimulatedBoard& board, PseudoTerminal& terminal, std::uint64_t seed, double start_s)
    : board_(board), terminal_(terminal), faults_(seed), start_s_(start_s) {}

void Bench::run_until(double host_s) {
  board_.receive(terminal_.read());
  board_.run_until(host_s - start_s_);
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

std::string Bench::command(std::string_view line, double host_s) {
  const std::size_t space = line.find(' ');
  const std::string_view word = line.substr(0, space);
  if (space != std::string_view::npos) {
    const std::string_view text = line.substr(space + 1);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size() || !(number >= 0.0)) {
      return "'" + std::string(text) + "' is no number from 0 up";
    }
    return with_number(word, number, host_s);
  }
  if (word == "reset") {
    board_.reset();
  } else if (word == "unplug") {
    terminal_.unplug();
  } else if (word == "plug") {
    terminal_.plug();
  } else {
    return "unknown command '" + std::string(word) + "'";
  }
  return {};
}

std::string Bench::with_number(std::string_view word, double number, double host_s) {
  if (word == "drop") {
    faults_.shares.drop = number;
  } else if (word == "double") {
    faults_.shares.duplicate = number;
  } else if (word == "flip") {
    faults_.shares.flip = number;
  } else if (word == "stall") {
    stalled_until_s_ = host_s + number;
  } else {
    return "unknown command '" + std::string(word) + " NUMBER'";
  }
  return {};
}

}  // namespace searig::board
