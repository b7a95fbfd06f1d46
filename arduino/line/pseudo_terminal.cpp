#include "arduino/line/pseudo_terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "acquisition/error.h"

namespace searig::line {
namespace {

/// No echo, no line editing: bytes as they are. Stays while the terminal lives.
void make_raw(const std::string& path) {
  const int slave = open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  termios line{};
  tcgetattr(slave, &line);
  cfmakeraw(&line);
  tcsetattr(slave, TCSANOW, &line);
  close(slave);
}

}  // namespace

PseudoTerminal::PseudoTerminal(std::filesystem::path link) : link_(std::move(link)) {}

PseudoTerminal::~PseudoTerminal() {
  unplug();
}

void PseudoTerminal::plug() {
  if (plugged()) return;
  master_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  std::array<char, 64> name{};
  if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0 ||
      ptsname_r(master_, name.data(), name.size()) != 0) {
    throw acquisition::InputError(std::string("no pseudo terminal: ") + std::strerror(errno));
  }
  path_ = name.data();
  make_raw(path_);
  if (link_.empty()) return;
  if (std::filesystem::is_symlink(link_)) std::filesystem::remove(link_);
  std::error_code error;
  std::filesystem::create_symlink(path_, link_, error);
  if (error) throw acquisition::InputError(link_.string() + ": " + error.message());
}

void PseudoTerminal::unplug() {
  if (!plugged()) return;
  std::error_code ignored;
  if (!link_.empty()) std::filesystem::remove(link_, ignored);
  close(std::exchange(master_, -1));
}

bool PseudoTerminal::listened_to() const {
  pollfd other{master_, 0, 0};
  return poll(&other, 1, 0) == 0 || (other.revents & POLLHUP) == 0;
}

std::vector<std::uint8_t> PseudoTerminal::read() {
  std::vector<std::uint8_t> bytes(512);
  const ssize_t count = plugged() ? ::read(master_, bytes.data(), bytes.size()) : 0;
  bytes.resize(static_cast<std::size_t>(count > 0 ? count : 0));
  return bytes;
}

void PseudoTerminal::write(std::span<const std::uint8_t> bytes) {
  if (!plugged() || !listened_to()) return;
  const ssize_t count = ::write(master_, bytes.data(), bytes.size());
  lost_ += bytes.size() - static_cast<std::size_t>(count > 0 ? count : 0);
}

}  // namespace searig::line
