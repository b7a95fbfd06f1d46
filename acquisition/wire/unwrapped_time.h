// A 32-bit counter of microseconds without its wraps.
#pragma once

#include <cmath>
#include <cstdint>

namespace searig::acquisition {

/// Follows a device clock that wraps every 2^32 us = 71.6 min. After a silence of any length the
/// host's clock tells how many wraps there were: it need only be right within half of one.
class UnwrappedTime {
 public:
  void begin(std::uint32_t time_us, double host_s) {
    us_ = time_us;
    host_s_ = host_s;
  }

  /// The unwrapped time of a reading, us; changes nothing.
  std::int64_t at(std::uint32_t time_us, double host_s) const {
    const auto step = static_cast<std::int32_t>(time_us - static_cast<std::uint32_t>(us_));
    const double expected_us = (host_s - host_s_) * 1e6;
    const double wraps = std::round((expected_us - step) / 4294967296.0);
    return us_ + step + (static_cast<std::int64_t>(wraps) << 32);
  }

  /// Goes on from a reading.
  void follow(std::int64_t us, double host_s) {
    us_ = us;
    host_s_ = host_s;
  }

  std::int64_t us() const { return us_; }
  double host_s() const { return host_s_; }

 private:
  std::int64_t us_ = 0;
  double host_s_ = 0.0;
};

}  // namespace searig::acquisition
