#include "acquisition/wire/plausible.h"

#include <algorithm>
#include <cmath>

namespace searig::acquisition {
namespace {

constexpr double kLongestStall = 60.0;  // s that a frame may be late, or catch up
constexpr double kWorstClock = 0.02;    // share by which a device clock may be wrong
constexpr double kFastest = 10e3;       // frames of one type in a second

}  // namespace

bool keep_time(double device_s, double host_s) {
  return std::abs(device_s - host_s) <= kLongestStall + kWorstClock * host_s;
}

bool can_skip(std::uint32_t frames, double seconds) {
  return static_cast<double>(frames) <= kFewLost + kFastest * std::max(0.0, seconds);
}

bool go_together(const Frame& a, const Frame& b) {
  const auto step_us = static_cast<std::int32_t>(b.header.time_us - a.header.time_us);
  if (a.header.boot != b.header.boot) return false;
  if (!keep_time(step_us * 1e-6, b.host_s - a.host_s)) return false;
  if (a.header.type != b.header.type) return true;
  return b.header.sequence > a.header.sequence &&
         can_skip(b.header.sequence - a.header.sequence, step_us * 1e-6);
}

}  // namespace searig::acquisition
