// A line to a device that is held for this program alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace searig::acquisition {

class Port {
 public:
  virtual ~Port() = default;

  enum class Opened : std::uint8_t { yes, absent, busy, refused };
  /// 8 data bits, no parity, one stop bit, no flow control. What was received before is thrown
  /// away. `device` may be a symbolic link (/dev/serial/by-id/...), followed anew at each opening.
  virtual Opened open(const std::string& device, unsigned baud) = 0;
  virtual void close() = 0;

  virtual bool is_open() const = 0;
  virtual int handle() const = 0;                  ///< to be polled for input, or -1
  const std::string& why() const { return why_; }  ///< of the last opening that failed
  std::size_t stale() const { return stale_; }     ///< bytes thrown away at the last opening

  /// Reads what is there, at most into `into`; how many bytes, or -1 where the device is gone.
  virtual int read(std::span<std::uint8_t> into) = 0;

  /// Writes without waiting; how many bytes the line took, or -1 where the device is gone.
  virtual int write(std::span<const std::uint8_t> bytes) = 0;

 protected:
  std::size_t stale_ = 0;
  std::string why_;
};

}  // namespace searig::acquisition
