#include "arduino/line/commands.h"

#include <unistd.h>

#include <array>
#include <charconv>
#include <iostream>

#include "acquisition/source/source.h"

namespace searig::line {
namespace {

/// The number from 0 up that is the whole text.
std::optional<double> number_in(std::string_view text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !(number >= 0.0)) return {};
  return number;
}

}  // namespace

int CommandLine::handle() const {
  return ended_ ? -1 : STDIN_FILENO;
}

void CommandLine::read() {
  std::array<char, 512> buffer;
  const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
  if (count <= 0) {
    ended_ = true;
    return;
  }
  unread_.append(buffer.data(), static_cast<std::size_t>(count));
  for (std::size_t end; (end = unread_.find('\n')) != std::string::npos;) {
    const std::string why = obey(std::string_view(unread_).substr(0, end));
    std::cout << (why.empty() ? "ok" : "error: " + why) << std::endl;
    unread_.erase(0, end + 1);
  }
}

std::string CommandLine::obey(std::string_view line) const {
  const std::size_t space = line.find(' ');
  Command command{line.substr(0, space), {}};
  if (space != std::string_view::npos) {
    command.number = number_in(line.substr(space + 1));
    if (!command.number) return "no number from 0 up: " + std::string(line);
  }
  return handler_(command) ? "" : "unknown command: " + std::string(line);
}

double DeviceTime::now_s() const {
  return stepped_ ? reached_s_ : acquisition::host_now_s();
}

bool DeviceTime::obey(const Command& command) {
  if (!stepped_ || command.word != "run" || !command.number) return false;
  reached_s_ = *command.number;
  return true;
}

bool set_fault(acquisition::FaultShares& shares, const Command& command) {
  if (!command.number) return false;
  if (command.word == "drop") {
    shares.drop = *command.number;
  } else if (command.word == "double") {
    shares.duplicate = *command.number;
  } else if (command.word == "flip") {
    shares.flip = *command.number;
  } else {
    return false;
  }
  return true;
}

}  // namespace searig::line
