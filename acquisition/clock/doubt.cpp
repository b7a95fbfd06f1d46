#include "acquisition/clock/doubt.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace searig::acquisition {
namespace {

constexpr double kRateError = 0.01;         // an Arduino's resonator was seen at 0.002
constexpr double kTrustedInterval = 0.010;  // s, the widest interval that is still of use

std::size_t steps_back(const std::vector<double>& host_s) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < host_s.size(); ++i) count += host_s[i] < host_s[i - 1];
  return count;
}

/// What only matters where the line alone says when things were.
std::string doubt_of_line(const Stream& stream, const HostLine& line) {
  if (line.timer == Timer::locked && line.unseen_wait_s > kTrustedInterval)
    return "the " + stream.name +
           printed(
               " stream's own step is a whole multiple of the %.0f ms of a USB timer, so a wait of "
               "up to %.0f ms would not show",
               1e3 * kUsbTimer, 1e3 * line.unseen_wait_s);
  if (line.ci95_s() > kTrustedInterval)
    return "the halves of the " + stream.name +
           printed(" stream disagree by %.1f ms", 1e3 * line.halves_apart_s);
  return {};
}

std::string doubt(const Stream& stream, const PingedRun& pinged) {
  const double ci_s = pinged.ci95_s(pinged.moments[pinged.moments.size() / 2].t_s);
  if (ci_s <= kTrustedInterval) return {};
  return "the pings to the " + stream.name + printed(" leave %.1f ms open", 1e3 * ci_s);
}

}  // namespace

std::string printed(const char* format, double a, double b) {
  char text[200];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

std::string doubt(const Stream& stream, const DeviceTrack& track) {
  const HostLine& line = track.line;
  if (line.rows < kFewRows)
    return "the " + stream.name + printed(" stream has only %.0f rows", double(line.rows));
  if (line.seconds < kShortRun)
    return "the " + stream.name + printed(" stream lasts only %.1f s", line.seconds);
  if (std::abs(line.delay.slope) > kRateError)
    return "the " + stream.name +
           printed(" clock would be wrong by %.0f ppm, more than any clock is",
                   1e6 * line.delay.slope);
  if (50 * steps_back(stream.host_s) > stream.host_s.size())
    return "the host's clock steps back between rows of the " + stream.name + " stream";
  if (line.lowest_percent_s > 0.001 && line.lowest_percent_s > 0.6 * line.median_s)
    return "a few rows of the " + stream.name +
           printed(" stream arrived %.1f ms before all others can, so the host's clock was set",
                   1e3 * line.lowest_percent_s);
  return track.pinged ? doubt(stream, *track.pinged) : doubt_of_line(stream, line);
}

bool heard_together(const Stream& a, const Stream& b) {
  const auto [a_low, a_high] = std::minmax_element(a.host_s.begin(), a.host_s.end());
  const auto [b_low, b_high] = std::minmax_element(b.host_s.begin(), b.host_s.end());
  return *a_low < *b_high && *b_low < *a_high;
}

}  // namespace searig::acquisition
