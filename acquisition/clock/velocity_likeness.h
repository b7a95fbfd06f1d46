// How alike a velocity is to the derivative of an angle that another device logged.
#pragma once

#include <span>
#include <vector>

namespace searig::acquisition {

/// A velocity in bins of one width; bins without a sample repeat the one before.
struct Binned {
  double start_s, width_s;
  std::vector<double> velocity;
};

Binned binned(std::span<const double> t, std::span<const double> v, double width_s);

/// A device's log, laid so that its first row falls on `first_s` of the reference's clock and its
/// last on `last_s`.
struct Laid {
  double first_s, last_s;
};

/// The derivative of the angle, averaged over the reference's bins; 0 outside the log.
std::vector<double> derivative(const Binned& reference, std::span<const double> device_s,
                               std::span<const double> angle, const Laid& laid);

/// velocity = gain*derivative + bias by least squares, gain >= 0.
struct Likeness {
  double gain = 0.0, bias = 0.0, correlation = -1.0, sse = 0.0;
};

Likeness likeness(const std::vector<double>& velocity, const std::vector<double>& derivative);

/// What that fit leaves, bin by bin.
std::vector<double> left_over(const std::vector<double>& velocity,
                              const std::vector<double>& derivative, const Likeness& fit);

/// How many samples of a correlated noise say as much as one of white noise: 1 + 2*sum of its
/// autocorrelation, as far as that stays positive.
double correlated(const std::vector<double>& noise);

}  // namespace searig::acquisition
