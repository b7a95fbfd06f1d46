#pragma once

#include "tests/proving/rig/rig.h"
#include "tests/proving/rig/term.h"

namespace searig::proving {

/// Physics that no catalogue names. e.form says which; each maker answers null for the others'.
std::unique_ptr<Torque> make_odd_spring(const Effect& effect, const Baseline& base);
std::unique_ptr<Torque> make_odd_drive(const Effect& effect, const Baseline& base);
std::unique_ptr<Gauge> make_odd_gauge(const Effect& effect);

/// Faults of the module's own sensors, as they change one row.
struct ModuleReading {
  double t_s, input_angle_rad, output_angle_rad, current_a;
};
void apply_odd_sensor(const Effect& effect, ModuleReading& reading);

}  // namespace searig::proving
