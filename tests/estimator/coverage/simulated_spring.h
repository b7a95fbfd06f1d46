// Springs with known parameters and a drive with known noise, to count how often an interval holds
// the truth. Written out here, with no use of the catalogue.
#pragma once

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "estimator/signals.h"

namespace searig::estimator {

/// What a simulation is made of; each seed draws its own parameters about these.
struct Springs {
  std::vector<std::string> states;
  double k = 50;           ///< N*m/rad, +-30 %
  double amplitude = 0.1;  ///< rad, of the deflection
  double rate_hz = 200;    ///< of the telemetry
  double seconds = 60;
  double white = 0.03;           ///< noise of the drive torque over its size, from sample to sample
  double coloured = 0.05;        ///< noise that hangs together, likewise
  double coloured_s = 0.1;       ///< for so long
  double encoder_rad = 1e-4;     ///< noise of the deflection
  double drift_per_minute = 0;   ///< of k, a random walk
  double softening_share = 0;    ///< by which k may wander with work; it comes back at rest
  double softening_work = 1500;  ///< over |T| |theta|
  double recovery_s = 600;
  double rest_from_s = 0, rest_to_s = 0;  ///< the spring is let go, for the recovery to show
};

struct SimulatedSpring {
  ModuleSignals module;
  std::vector<double> drive_nm;
  std::map<std::string, double> truth;  ///< by parameter name, at the end
};

class SpringSimulation {
 public:
  SpringSimulation(const Springs& springs, unsigned seed) : s_(springs), random_(seed) {
    for (int i = 0; i < 4; ++i) {
      sines_.push_back({uniform(0.5, 1), 2 * M_PI * uniform(0.2, 1.5), uniform(0, 2 * M_PI)});
    }
  }

  SimulatedSpring run() {
    SimulatedSpring out;
    const double k0 = s_.k * uniform(0.7, 1.3), size = k0 * s_.amplitude;
    double loss = 0, k = k0, relaxed = 0, coloured = 0, last_theta = 0;
    const double c = has("viscous") ? 0.1 * k0 / 5 * uniform(0.5, 1.5) : 0;
    const double k3 = has("cubic") ? 0.3 * k0 / (s_.amplitude * s_.amplitude) * uniform(-1, 1) : 0;
    const double per_c = has("temperature") ? uniform(-0.01, 0.01) : 0;
    const double k1 = has("relaxation") ? 0.2 * k0 * uniform(0.5, 1.5) : 0;
    const double dt = 1 / s_.rate_hz, stays = std::exp(-dt / s_.coloured_s);
    double mean_torque = 0, mean_theta = 0;
    int moving = 0;
    for (int i = 0; i < s_.seconds * s_.rate_hz; ++i) {
      const double t = i * dt, theta = motion(t);
      const double rate = (motion(t + 1e-5) - motion(t - 1e-5)) / 2e-5;
      const double warmer = 20 * (1 - std::exp(-t / 30)) + 2 * std::sin(t / 7);
      relaxed += (theta - relaxed) * (1 - std::exp(-dt / relaxation_s));
      const double T = (k - loss) * theta * (1 + per_c * warmer) + c * rate +
                       k3 * theta * theta * theta + k1 * (theta - relaxed);

      const bool rests = t >= s_.rest_from_s && t < s_.rest_to_s;
      const double rise = std::abs(theta) - std::abs(last_theta);
      if (!rests) {
        ++moving;
        mean_torque += (std::abs(T) - mean_torque) / moving;
        mean_theta += (std::abs(theta) - mean_theta) / moving;
      }
      if (rests) loss *= std::exp(-dt / s_.recovery_s);
      if (!rests && rise > 0 && i > 50) {
        const double work = std::abs(T) * rise / (mean_torque * mean_theta);
        loss += s_.softening_share * k * std::sqrt(work / s_.softening_work) * normal_(random_);
      }
      k += s_.drift_per_minute * std::sqrt(dt / 60) * k * normal_(random_);
      last_theta = theta;

      coloured = stays * coloured + std::sqrt(1 - stays * stays) * normal_(random_);
      out.module.t_s.push_back(t);
      out.module.deflection_rad.push_back(theta + s_.encoder_rad * normal_(random_));
      out.module.spring_temperature_c.push_back(25 + warmer);
      out.drive_nm.push_back(T + size * (s_.white * normal_(random_) + s_.coloured * coloured));
    }
    out.truth = {{"k_nm_per_rad", k},           {"c_nm_s_per_rad", c},
                 {"k3_nm_per_rad3", k3},        {"per_c", per_c},
                 {"k1_nm_per_rad", k1},         {"share", loss / k},
                 {"k_now_nm_per_rad", k - loss}};
    return out;
  }

  static constexpr double relaxation_s = 0.5;

 private:
  struct Sine {
    double amplitude, rad_s, phase;
  };

  double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }

  bool has(const std::string& what) const {
    for (const std::string& state : s_.states) {
      if (state.find(what) != std::string::npos) return true;
    }
    return false;
  }

  double motion(double t) const {
    if (t >= s_.rest_from_s && t < s_.rest_to_s) return 0;
    double sum = 0;
    for (const Sine& sine : sines_) sum += sine.amplitude * std::sin(sine.rad_s * t + sine.phase);
    return s_.amplitude * sum / 1.5;
  }

  Springs s_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  std::vector<Sine> sines_;
};

}  // namespace searig::estimator
