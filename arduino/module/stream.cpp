#include "arduino/module/stream.h"

#include <utility>

namespace searig::module {
namespace {

constexpr std::size_t kPast = 256;
constexpr std::size_t kMostAtOnce = 10'000;

}  // namespace

Stream::Stream(SimulatedModule& module, Link& link, std::uint64_t seed, double start_s)
    : module_(module), link_(link), faults_(seed), start_s_(start_s) {}

void Stream::hear() {
  for (Bytes request; !(request = link_.receive()).empty();) heard_.push_back(std::move(request));
}

void Stream::run_until(double host_s) {
  for (; !heard_.empty(); heard_.pop_front()) {
    const Bytes answer = module_.answer(heard_.front(), host_s - start_s_);
    if (!answer.empty()) send(answer);
  }
  while (next_s() <= host_s) send(module_.take_sample());
  flush(host_s);
}

void Stream::send(const Bytes& frame) {
  ++sent_;
  past_.push_back(frame);
  if (past_.size() > kPast) past_.pop_front();
  const Bytes passed = faults_.pass(frame);
  if (!passed.empty()) held_.push_back(passed);
}

void Stream::flush(double host_s) {
  if (host_s < stalled_until_s_) return;
  for (const Bytes& bytes : held_) link_.send(bytes);
  held_.clear();
}

bool Stream::obey(const line::Command& command, double host_s) {
  if (line::set_fault(faults_.shares, command)) return true;
  if (command.word == "stall" && command.number) {
    stalled_until_s_ = host_s + *command.number;
    return true;
  }
  if (command.number) return disturb(command.word, static_cast<std::size_t>(*command.number));
  if (command.word == "reset") {
    module_.restart(host_s - start_s_);
  } else if (command.word == "unplug" || command.word == "plug") {
    link_.plug(command.word == "plug");
  } else {
    return false;
  }
  return true;
}

bool Stream::disturb(std::string_view word, std::size_t count) {
  if (count > kMostAtOnce) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const Bytes old = past_.empty() ? Bytes{} : past_[i % past_.size()];
    if (word == "foreign") {
      link_.send_as_stranger(old);
    } else if (word == "replay") {
      link_.send(old);
    } else if (word == "long") {
      link_.send(Bytes(2000, 1));
    } else if (word == "garbage") {
      link_.send(Bytes(30, static_cast<std::uint8_t>(1 + i % 255)));
    } else {
      return false;
    }
  }
  return true;
}

}  // namespace searig::module
