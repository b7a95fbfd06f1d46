#include "estimator/physics/motion.h"

#include <algorithm>

#include "estimator/kinematics.h"

namespace searig::estimator {

const std::vector<double>* channel_of(const Motion& m, std::string_view name) {
  const std::pair<std::string_view, const std::vector<double>*> channels[] = {
      {"time_s", &m.t},
      {"deflection_rad", &m.theta},
      {"deflection_rate_rad_s", &m.theta_rate},
      {"input_angle_rad", &m.q_i},
      {"input_velocity_rad_s", &m.w},
      {"input_acceleration_rad_s2", &m.a},
      {"output_angle_rad", &m.q_o},
      {"output_velocity_rad_s", &m.w_o},
      {"output_acceleration_rad_s2", &m.a_o},
      {"current_a", &m.current},
      {"winding_temperature_c", &m.winding_c},
      {"spring_temperature_c", &m.spring_c},
      {"spring_torque_nm", &m.spring_nm},
      {"loadcell_torque_nm", &m.spring_nm}};
  for (const auto& [known, values] : channels)
    if (known == name) return values->empty() ? nullptr : values;
  return nullptr;
}

Motion motion_of(const ModuleSignals& module, double half_width_s) {
  Motion m;
  m.t = module.t_s;
  if (!m.t.empty()) {
    const double start = m.t.front();
    for (double& t : m.t) t -= start;
  }
  // Over the times as they came: what a sample is given depends on its neighbours alone, to the last
  // bit, and not on where the recording begins; so live and batch estimates agree.
  const auto take = [&](const std::vector<double>& angle, auto& x, auto& v, auto& a) {
    if (angle.empty()) return;
    auto k = differentiate(module.t_s, angle, half_width_s);
    x = std::move(k.value), v = std::move(k.first), a = std::move(k.second);
  };
  take(module.deflection_rad, m.theta, m.theta_rate, m.theta_accel);
  take(module.input_angle_rad, m.q_i, m.w, m.a);
  take(module.output_angle_rad, m.q_o, m.w_o, m.a_o);
  if (m.w.empty() && !module.input_velocity_rad_s.empty()) {
    auto k = differentiate(module.t_s, module.input_velocity_rad_s, half_width_s);
    m.w = std::move(k.value), m.a = std::move(k.first);
  }
  m.current = module.current_a;
  m.winding_c = module.winding_temperature_c;
  m.spring_c = module.spring_temperature_c;
  return m;
}

}  // namespace searig::estimator
