// A spring and a perfect drive, moved by two sines after a rest: signals with a known stiffness.
#pragma once

#include <cmath>
#include <random>
#include <vector>

namespace searig::estimator {

struct HandMade {
  double k = 50;            ///< N*m/rad
  double amplitude = 0.08;  ///< rad
  double speed = 1;         ///< of the motion; 1 is slow hand movements, 0.5 Hz
  double rate_hz = 250;     ///< of the telemetry
  double rest_s = 1;        ///< before anything moves
  double noise = 0.005;     ///< of deflection and drive torque, relative to their amplitudes
  double friction = 0;      ///< Coulomb friction that the drive model lacks, over k*amplitude

  std::vector<double> t = {}, theta = {}, drive = {};  ///< what make() fills

  HandMade& make(double seconds, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, noise);
    for (int i = 0; i < seconds * rate_hz; ++i) {
      const double time = i / rate_hz, moving = std::max(0.0, time - rest_s) * speed;
      const double shape = 0.7 * std::sin(3.1 * moving) + 0.3 * std::sin(5.3 * moving);
      const double rate = 0.7 * 3.1 * std::cos(3.1 * moving) + 0.3 * 5.3 * std::cos(5.3 * moving);
      const double sign = moving > 0 ? std::tanh(rate / 0.05) : 0;
      t.push_back(time);
      theta.push_back(amplitude * (shape + 0.1 * normal(random)));
      drive.push_back(k * amplitude * (shape + friction * sign + normal(random)));
    }
    return *this;
  }
};

}  // namespace searig::estimator
