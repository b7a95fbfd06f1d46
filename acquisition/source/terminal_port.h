// A pseudo terminal as a line: what the simulated board sits behind.
#pragma once

#include "acquisition/source/port.h"

namespace searig::acquisition {

/// By the system's own calls, since libserialport 0.1.1 takes no terminal for a port that is not in
/// /sys/class/tty. For a real port: SerialPort.
class TerminalPort : public Port {
 public:
  TerminalPort() = default;
  ~TerminalPort() override { TerminalPort::close(); }
  TerminalPort(const TerminalPort&) = delete;
  TerminalPort& operator=(const TerminalPort&) = delete;

  Opened open(const std::string& device, unsigned baud) override;  ///< it has no baud
  void close() override;
  bool is_open() const override { return handle_ >= 0; }
  int handle() const override { return handle_; }
  int read(std::span<std::uint8_t> into) override;
  int write(std::span<const std::uint8_t> bytes) override;

 private:
  int handle_ = -1;
};

}  // namespace searig::acquisition
