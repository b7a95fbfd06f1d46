#include "acquisition/source/terminal_port.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace searig::acquisition {
namespace {

bool make_raw(int handle) {
  termios line{};
  if (tcgetattr(handle, &line) != 0) return false;
  cfmakeraw(&line);
  return tcsetattr(handle, TCSANOW, &line) == 0;
}

}  // namespace

Port::Opened TerminalPort::open(const std::string& device, unsigned) {
  close();
  handle_ = ::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (handle_ < 0) {
    why_ = device + (errno == ENOENT ? " is not there"
                                     : std::string(" cannot be opened: ") + std::strerror(errno));
    return errno == ENOENT || errno == EIO ? Opened::absent : Opened::refused;
  }
  if (flock(handle_, LOCK_EX | LOCK_NB) != 0) {
    why_ = device + " is in use by another program";
    close();
    return Opened::busy;
  }
  if (!make_raw(handle_)) {
    why_ = device + " is no terminal";
    close();
    return Opened::refused;
  }
  int waiting = 0;
  ioctl(handle_, FIONREAD, &waiting);
  stale_ = static_cast<std::size_t>(waiting > 0 ? waiting : 0);
  tcflush(handle_, TCIFLUSH);
  return Opened::yes;
}

void TerminalPort::close() {
  if (handle_ >= 0) ::close(std::exchange(handle_, -1));
}

int TerminalPort::read(std::span<std::uint8_t> into) {
  pollfd ready{handle_, POLLIN, 0};
  if (poll(&ready, 1, 0) <= 0) return 0;
  const ssize_t count = ::read(handle_, into.data(), into.size());
  if (count > 0) return static_cast<int>(count);
  return count < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1;
}

int TerminalPort::write(std::span<const std::uint8_t> bytes) {
  const ssize_t count = ::write(handle_, bytes.data(), bytes.size());
  if (count >= 0) return static_cast<int>(count);
  return errno == EAGAIN || errno == EINTR ? 0 : -1;
}

}  // namespace searig::acquisition
