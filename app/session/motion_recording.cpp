// The motion of a spec as a recording without torques.
#include "app/session/motion_spec.h"

namespace searig::app {
namespace {

std::vector<double> ramp(const std::vector<double>& from_to, const std::vector<double>& t) {
  std::vector<double> out;
  for (const double s : t)
    out.push_back(from_to.front() + (from_to.back() - from_to.front()) * s / t.back());
  return out;
}

}  // namespace

acquisition::Recording recording_of(const MotionSpec& spec) {
  const auto angles = estimator::angles_of(spec.motion, spec.module_hz);
  acquisition::Recording out;
  out.name = "simulated";
  out.one_clock = true;
  out.module.name = "module";
  out.module.t_s = angles.t_s;
  out.module.channels = {{"input_angle_rad", angles.input_angle_rad},
                         {"output_angle_rad", angles.output_angle_rad}};
  const auto add_temperature = [&](const char* name, const std::vector<double>& from_to) {
    if (!from_to.empty()) out.module.channels.push_back({name, ramp(from_to, out.module.t_s)});
  };
  add_temperature("spring_temperature_c", spec.spring_c);
  add_temperature("winding_temperature_c", spec.winding_c);
  out.loadcell.name = "loadcell";
  for (std::size_t i = 0; double(i) <= spec.motion.seconds * spec.loadcell_hz; ++i)
    out.loadcell.t_s.push_back(double(i) / spec.loadcell_hz);
  out.loadcell.channels = {{"torque_nm", std::vector<double>(out.loadcell.t_s.size(), 0.0)}};
  return out;
}

}  // namespace searig::app
