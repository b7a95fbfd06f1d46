#pragma once

#include <memory>
#include <vector>

namespace searig::proving {

/// What a piece of physics can feel at one instant.
struct Instant {
  double t_s = 0.0;  ///< since the recording started; negative before
  double deflection_rad = 0.0, deflection_rate_rad_s = 0.0;
  double input_angle_rad = 0.0, input_velocity_rad_s = 0.0;
  double output_angle_rad = 0.0, output_velocity_rad_s = 0.0;
  double current_a = 0.0;
  double linear_torque_nm = 0.0;  ///< k*theta
  double spring_torque_nm = 0.0;  ///< the whole spring, for terms of the drive and the rig
  double winding_c = 25.0, spring_c = 25.0;
};

/// A torque with memory: called once per integration step with the step's instant.
class Torque {
 public:
  virtual ~Torque() = default;
  virtual double advance(const Instant& now, double dt_s) = 0;
};

/// Something between the true torque at the lever and what the load cell reports.
class Gauge {
 public:
  virtual ~Gauge() = default;
  virtual double advance(double torque_nm, const Instant& now, double dt_s) = 0;
};

using Torques = std::vector<std::unique_ptr<Torque>>;
using Gauges = std::vector<std::unique_ptr<Gauge>>;

/// A torque written as one formula without memory.
template <typename Formula>
class Formulated final : public Torque {
 public:
  explicit Formulated(Formula formula) : formula_(std::move(formula)) {}
  double advance(const Instant& now, double) override { return formula_(now); }

 private:
  Formula formula_;
};

template <typename Formula>
std::unique_ptr<Torque> formulated(Formula formula) {
  return std::make_unique<Formulated<Formula>>(std::move(formula));
}

inline double sum(const Torques& terms, const Instant& now, double dt_s) {
  double total = 0.0;
  for (const auto& term : terms) total += term->advance(now, dt_s);
  return total;
}

}  // namespace searig::proving
