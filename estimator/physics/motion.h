// What the effects act on: one experiment's motion at the module's samples, smoothed.
#pragma once

#include <string_view>
#include <vector>

#include "estimator/signals.h"

namespace searig::estimator {

/// All vectors have the size of t, or are empty where the recording lacks the channel. Angles in
/// rad, rates in rad/s, accelerations in rad/s^2, torques in N*m, temperatures in degrees Celsius.
struct Motion {
  std::vector<double> t;                               ///< s, module clock, from 0
  std::vector<double> theta, theta_rate, theta_accel;  ///< deflection, from the input to the output
  std::vector<double> q_i, w, a;                       ///< input angle, its velocity, acceleration
  std::vector<double> q_o, w_o, a_o;                   ///< output angle and its derivatives
  std::vector<double> current;                         ///< A, as measured
  std::vector<double> winding_c, spring_c;
  std::vector<double> spring_nm;  ///< T_spring, for the effects that depend on the load

  double smoothing_rad_s = 0.01;  ///< width of tanh(w/smoothing), one for all friction terms
  double gear_ratio = 1.0;        ///< motor turns per turn of q_i
  double reference_c = 25.0;      ///< where temperature coefficients are measured from

  std::size_t size() const { return t.size(); }
  bool has_spring() const { return !theta.empty(); }
  bool has_drive() const { return !current.empty() && !w.empty(); }
};

/// A channel by the name that the diagnosis gives it ("deflection_rate_rad_s"); nullptr where the
/// recording lacks it.
const std::vector<double>* channel_of(const Motion& motion, std::string_view name);

/// Differentiates over +-half_width_s around each sample. Where the module reports its own input
/// velocity and no angle, that velocity is taken.
Motion motion_of(const ModuleSignals& module, double half_width_s);

}  // namespace searig::estimator
