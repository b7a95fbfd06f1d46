#include "acquisition/clock/host_timer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace searig::acquisition {

Timer timer_in(std::span<const double> t_s, std::span<const double> host_s) {
  constexpr double kSlack = kUsbTimer / 16.0;  // a tick is stamped within a millisecond
  std::size_t steps = 0, at_ticks = 0, like_the_device = 0;
  for (std::size_t i = 1; i < host_s.size(); ++i) {
    const double step = host_s[i] - host_s[i - 1];
    if (step < kSlack) continue;  // heard at the same tick
    ++steps;
    at_ticks += std::abs(step - kUsbTimer * std::round(step / kUsbTimer)) < kSlack;
    like_the_device += std::abs(step - (t_s[i] - t_s[i - 1])) < kSlack;
  }
  if (steps <= 20 || 5 * at_ticks <= 4 * steps) return Timer::absent;
  return 2 * like_the_device < steps ? Timer::heard : Timer::locked;
}

double unseen_wait(std::span<const double> above_s, double timer_s) {
  std::vector<double> waits;
  for (const double wait : above_s)
    if (wait < timer_s) waits.push_back(wait);
  waits.push_back(timer_s);  // one tick later is the same wait
  std::sort(waits.begin(), waits.end());
  double widest = 0.0;
  for (std::size_t i = 1; i < waits.size(); ++i) widest = std::max(widest, waits[i] - waits[i - 1]);
  return widest;
}

}  // namespace searig::acquisition
