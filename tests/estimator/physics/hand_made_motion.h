// Twenty seconds of motion written down as sines, so that every rate in it is exact, at times that
// are not evenly spaced; and the torque that a term of a model brings on it.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "estimator/model/model.h"
#include "estimator/physics/catalogue.h"
#include "estimator/physics/motion.h"

namespace searig::estimator {

inline Motion hand_made_motion() {
  Motion m;
  for (int i = 0; i < 2000; ++i) {
    const double t = 0.01 * i + (i > 0 ? 0.003 * std::sin(1.7 * i) : 0.0);
    m.t.push_back(t);
    m.theta.push_back(0.2 * std::sin(2 * t) + 0.05 * std::sin(5.3 * t));
    m.theta_rate.push_back(0.4 * std::cos(2 * t) + 0.265 * std::cos(5.3 * t));
    m.theta_accel.push_back(-0.8 * std::sin(2 * t) - 1.4045 * std::sin(5.3 * t));
    m.q_o.push_back(0.1 + 0.5 * std::sin(1.1 * t));
    m.w_o.push_back(0.55 * std::cos(1.1 * t));
    m.a_o.push_back(-0.605 * std::sin(1.1 * t));
    m.q_i.push_back(m.q_o.back() + m.theta.back());
    m.w.push_back(m.w_o.back() + m.theta_rate.back());
    m.a.push_back(m.a_o.back() + m.theta_accel.back());
    m.current.push_back(0.3 + 1.5 * std::sin(1.9 * t));
    m.winding_c.push_back(25 + t);
    m.spring_c.push_back(22 + 0.25 * t);
    m.spring_nm.push_back(40 * m.theta.back());
  }
  m.smoothing_rad_s = 0.02;
  return m;
}

/// k = 40 N*m/rad; 2.6 N*m/A at an efficiency of 0.75.
inline Model hand_made_model() {
  Model model;
  model.set("spring.linear", "k_nm_per_rad", 40);
  model.set("drive.motor", "torque_constant_nm_per_a", 2.6);
  model.set("drive.motor", "efficiency", 0.75);
  return model;
}

inline Eigen::VectorXd torque_of(const Term& term, const Motion& motion) {
  const Effect& effect = *find_effect(term.effect);
  return effect.features(motion, effect.shape(term)) * effect.amplitudes(term, hand_made_model());
}

/// A motion that has nothing but a deflection, evenly spaced in time.
inline Motion deflected(const std::vector<double>& theta, double step_s) {
  Motion m;
  m.theta = theta;
  for (std::size_t i = 0; i < theta.size(); ++i) m.t.push_back(step_s * double(i));
  m.spring_nm = theta;
  return m;
}

/// Straight from corner to corner, `n` steps each.
inline std::vector<double> path_through(const std::vector<double>& corners, int n) {
  std::vector<double> out{corners.front()};
  for (std::size_t c = 1; c < corners.size(); ++c)
    for (int i = 1; i <= n; ++i)
      out.push_back(corners[c - 1] + (corners[c] - corners[c - 1]) * i / n);
  return out;
}

}  // namespace searig::estimator
