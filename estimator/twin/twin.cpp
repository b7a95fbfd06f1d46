#include "estimator/twin/twin.h"

#include <algorithm>
#include <cmath>

#include "estimator/twin/control.h"

namespace searig::estimator::twin {
namespace {

constexpr int steps_per_control = 10;  // of 0.1 ms: a twentieth of the lever's fastest swing

}  // namespace

Twin::Twin(const Parameters& parameters, std::uint64_t seed)
    : parameters_(parameters),
      motion_(parameters.motion, seed),
      plant_(parameters),
      module_sensors_(parameters, seed + 100),
      loadcell_sensors_(parameters, seed + 200) {}

void Twin::advance_to(double t_s) {
  const double dt = parameters_.controller.period_s / steps_per_control;
  const auto last = static_cast<std::uint64_t>(std::max(0.0, std::floor(t_s / dt)));
  for (; steps_ < last; ++steps_) {
    if (steps_ % steps_per_control == 0) control();
    plant_.step(current_a_, motion_.hand_angle_rad(static_cast<double>(steps_) * dt), dt);
  }
}

// Held for one period.
void Twin::control() {
  const double t_s =
      static_cast<double>(steps_ / steps_per_control) * parameters_.controller.period_s;
  commanded_angle_rad_ = motion_.commanded_angle_rad(t_s);
  current_a_ = loop_current_a(parameters_, commanded_angle_rad_, plant_.state());
}

ModuleReading Twin::read_module() {
  return module_sensors_.module(plant_.state(), current_a_, commanded_angle_rad_);
}

LoadcellReading Twin::read_loadcell() {
  return loadcell_sensors_.loadcell(plant_.state());
}

}  // namespace searig::estimator::twin
