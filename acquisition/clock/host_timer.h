// A host that hears a device only at the ticks of a timer, as through an FTDI chip's 16 ms.
#pragma once

#include <span>

namespace searig::acquisition {

constexpr double kUsbTimer = 0.016;  ///< s, the latency timer of FTDI's USB-serial chips

/// Whether arrivals come at ticks of the USB timer: most steps of the host's stamps are whole
/// multiples of it although the device's own steps are not. (A device whose own step is a whole
/// multiple of 16 ms cannot be told from one that is heard at once.)
bool heard_at_ticks(std::span<const double> t_s, std::span<const double> host_s);

/// How much of the wait for a tick was never seen, s. Waits fill [0, timer) evenly as the device's
/// beat drifts through the ticks; where the two are locked they take a few values only, and the
/// shortest possible wait may be shorter than the shortest one seen by the widest gap between them.
/// above_s: how far each arrival lies above the line under all.
double unseen_wait(std::span<const double> above_s, double timer_s);

}  // namespace searig::acquisition
