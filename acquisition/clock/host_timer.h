// A host that hears a device only at the ticks of a timer, as through an FTDI chip's 16 ms.
#pragma once

#include <span>

namespace searig::acquisition {

constexpr double kUsbTimer = 0.016;  ///< s, the latency timer of FTDI's USB-serial chips

/// What the steps between arrivals say of the USB timer.
enum class Timer {
  absent,  ///< most steps are no whole multiples of it
  heard,   ///< most are, although the device's own steps are not
  /// The device's own step is a whole multiple of 16 ms: heard at once or at the ticks, it looks
  /// the same, and each row may have waited the same unknown part of a tick.
  locked
};
Timer timer_in(std::span<const double> t_s, std::span<const double> host_s);

/// How much of the wait for a tick was never seen, s. Waits fill [0, timer) evenly as the device's
/// beat drifts through the ticks; where the two are locked they take a few values only, and the
/// shortest possible wait may be shorter than the shortest one seen by the widest gap between them.
/// above_s: how far each arrival lies above the line under all.
double unseen_wait(std::span<const double> above_s, double timer_s);

}  // namespace searig::acquisition
