#include "acquisition/source/serial_port.h"

#include <fcntl.h>
#include <libserialport.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace searig::acquisition {
namespace {

/// The device behind a symbolic link, as libserialport looks for it in /sys/class/tty by its name.
std::string real_device(const std::string& device) {
  char* const real = realpath(device.c_str(), nullptr);
  const std::string path = real != nullptr ? real : "";
  std::free(real);
  return path;
}

/// Without HUPCL: closing the port does not reset an Arduino.
bool stay_up(int handle) {
  termios line{};
  if (tcgetattr(handle, &line) != 0) return false;
  line.c_cflag &= ~static_cast<tcflag_t>(HUPCL);
  return tcsetattr(handle, TCSANOW, &line) == 0;
}

bool set_line(sp_port* port, unsigned baud) {
  return sp_set_baudrate(port, static_cast<int>(baud)) == SP_OK && sp_set_bits(port, 8) == SP_OK &&
         sp_set_parity(port, SP_PARITY_NONE) == SP_OK && sp_set_stopbits(port, 1) == SP_OK &&
         sp_set_flowcontrol(port, SP_FLOWCONTROL_NONE) == SP_OK;
}

}  // namespace

SerialPort::Opened SerialPort::open(const std::string& device, unsigned baud) {
  close();
  const Opened opened = take(device, baud);
  if (opened != Opened::yes) close();
  return opened;
}

SerialPort::Opened SerialPort::take(const std::string& device, unsigned baud) {
  const std::string real = real_device(device);
  if (real.empty()) {
    why_ = device + " is not there";
    return Opened::absent;
  }
  if (sp_get_port_by_name(real.c_str(), &port_) != SP_OK) {
    port_ = nullptr;
    why_ = device + " is no serial port";
    return Opened::refused;
  }
  if (const Opened locked = lock(device, real); locked != Opened::yes) return locked;
  if (sp_open(port_, SP_MODE_READ_WRITE) != SP_OK || sp_get_port_handle(port_, &handle_) != SP_OK ||
      !set_line(port_, baud) || !stay_up(handle_)) {
    why_ = device + " cannot be set to " + std::to_string(baud) + " baud";
    return Opened::refused;
  }
  ioctl(handle_, TIOCEXCL);
  stale_ = static_cast<std::size_t>(std::max(0, static_cast<int>(sp_input_waiting(port_))));
  sp_flush(port_, SP_BUF_INPUT);
  return Opened::yes;
}

/// Keeps others out. TIOCEXCL, set later, refuses whoever opens the port from then on, but not
/// root; flock refuses all who ask for it, as we do and many terminal programs.
SerialPort::Opened SerialPort::lock(const std::string& device, const std::string& real) {
  lock_ = ::open(real.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  const int error = errno;
  if ((lock_ < 0 && error == EBUSY) || (lock_ >= 0 && flock(lock_, LOCK_EX | LOCK_NB) != 0)) {
    why_ = device + " is in use by another program";
    return Opened::busy;
  }
  if (lock_ >= 0) return Opened::yes;
  why_ = device + " cannot be opened: " + std::strerror(error);
  if (error == EACCES) why_ += " (may you use serial ports? On Debian: adduser YOU dialout)";
  const bool absent = error == ENOENT || error == ENXIO || error == ENODEV || error == EIO;
  return absent ? Opened::absent : Opened::refused;
}

void SerialPort::close() {
  if (handle_ >= 0) ioctl(handle_, TIOCNXCL);
  if (handle_ >= 0) sp_close(port_);
  if (port_ != nullptr) sp_free_port(port_);
  if (lock_ >= 0) ::close(lock_);
  port_ = nullptr;
  handle_ = lock_ = -1;
}

int SerialPort::read(std::span<std::uint8_t> into) {
  pollfd ready{handle_, POLLIN, 0};
  if (poll(&ready, 1, 0) <= 0) return 0;
  const int count = sp_nonblocking_read(port_, into.data(), into.size());
  // Ready, and yet nothing there: the end of the line. What came before it is read first.
  if (count > 0) return count;
  const bool gone = (ready.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
  return gone || count < 0 || (ready.revents & POLLIN) != 0 ? -1 : 0;
}

int SerialPort::write(std::span<const std::uint8_t> bytes) {
  return sp_nonblocking_write(port_, bytes.data(), bytes.size());
}

}  // namespace searig::acquisition
