// A serial port held for this program alone, through libserialport.
#pragma once

#include "acquisition/source/port.h"

struct sp_port;

namespace searig::acquisition {

/// libserialport 0.1.1 (2016, in Debian 12) leaves to its user what is done here: no other program
/// may open the port meanwhile; closing it does not reset an Arduino (HUPCL); a device that is gone
/// is noticed at once instead of reading nothing for ever.
class SerialPort : public Port {
 public:
  SerialPort() = default;
  ~SerialPort() override { SerialPort::close(); }
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  Opened open(const std::string& device, unsigned baud) override;
  void close() override;
  bool is_open() const override { return port_ != nullptr; }
  int handle() const override { return handle_; }
  int read(std::span<std::uint8_t> into) override;
  int write(std::span<const std::uint8_t> bytes) override;

 private:
  Opened take(const std::string& device, unsigned baud);
  Opened lock(const std::string& device, const std::string& real);

  sp_port* port_ = nullptr;
  int handle_ = -1;  ///< libserialport's
  int lock_ = -1;    ///< our own, taken before libserialport touches a port that others may use
};

}  // namespace searig::acquisition
