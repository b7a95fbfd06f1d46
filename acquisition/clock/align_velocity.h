// Two clocks brought together by a motion that both devices saw.
#pragma once

#include <span>
#include <string>

namespace searig::acquisition {

/// time of the reference = rate * device time + offset_s, and how well that is known.
struct Alignment {
  double rate = 1.0;
  double offset_s = 0.0;
  double ci95_s = 0.0;  ///< half width of the 95 % interval at the middle of the device's log
  double correlation = 0.0;
  bool trusted = true;
  std::string why;  ///< one sentence
};

/// Finds where the derivative of a device's angle is most like a velocity, in rad/s, that another
/// device reports on its own clock: velocity = gain*derivative + bias, gain > 0. Both may be noisy;
/// gain and bias are free, since firmware filters and offsets what it reports.
///
/// Before and after its log the device is taken to stand still, so that a log that begins and ends
/// with its motion is placed by its two ends. The rates of two quartz clocks are taken to be within
/// some 100 ppm of each other, which a long recording corrects.
///
/// Not trusted: no likeness beyond chance, another place where they are as much alike (a periodic
/// motion), or an interval wider than the motion itself. Times must rise.
Alignment align_by_velocity(std::span<const double> reference_s, std::span<const double> velocity,
                            std::span<const double> device_s, std::span<const double> angle);

}  // namespace searig::acquisition
