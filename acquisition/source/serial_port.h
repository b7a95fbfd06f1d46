// A serial port held for this program alone, through libserialport.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

struct sp_port;

namespace searig::acquisition {

/// libserialport 0.1.1 (2016, in Debian 12) leaves to its user what is done here: no other program
/// may open the port meanwhile; closing it does not reset an Arduino (HUPCL); a device that is gone
/// is noticed at once instead of reading nothing for ever.
class SerialPort {
 public:
  SerialPort() = default;
  ~SerialPort() { close(); }
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  enum class Opened : std::uint8_t { yes, absent, busy, refused };
  /// 8 data bits, no parity, one stop bit, no flow control. What was received before is thrown
  /// away. `device` may be a symbolic link (/dev/serial/by-id/...), followed anew at each opening.
  Opened open(const std::string& device, unsigned baud);
  void close();

  bool is_open() const { return port_ != nullptr; }
  int handle() const { return handle_; }
  const std::string& why() const { return why_; }  ///< of the last opening that failed
  std::size_t stale() const { return stale_; }     ///< bytes thrown away at the last opening

  /// Reads what is there, at most into `into`; how many bytes, or -1 where the device is gone.
  int read(std::span<std::uint8_t> into);

  /// Writes without waiting; how many bytes the line took, or -1 where the device is gone.
  int write(std::span<const std::uint8_t> bytes);

 private:
  Opened take(const std::string& device, unsigned baud);
  Opened lock(const std::string& device, const std::string& real);

  sp_port* port_ = nullptr;
  int handle_ = -1;  ///< libserialport's
  int lock_ = -1;    ///< our own, taken before libserialport touches a port that others may use
  std::size_t stale_ = 0;
  std::string why_;
};

}  // namespace searig::acquisition
