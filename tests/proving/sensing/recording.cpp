#include "tests/proving/sensing/recording.h"

#include <cmath>
#include <numbers>

#include "tests/proving/rig/oddity.h"

namespace searig::proving {
namespace {

double quantised(double value, double step) {
  return step > 0.0 ? std::round(value / step) * step : value;
}

/// Encoders interpolate between lines, not quite evenly, before they count.
double encoder(double angle, const Sensing& s) {
  const double period = 8.0 * s.angle_step_rad;
  const double uneven =
      s.interpolation_error_rad * std::sin(2.0 * std::numbers::pi * angle / period);
  return quantised(angle + uneven, s.angle_step_rad);
}

std::vector<ModuleRow> observe_module(const Trace& trace, const Rig& rig, const Sensing& s) {
  const Random random(s.seed);
  Random noise = random.fork("module noise");
  Link link(s.module_link, random.fork("module link"));
  const Effect* offset = rig.find("drive.current_offset");
  std::vector<ModuleRow> rows;
  const auto count = static_cast<int>(rig.duration_s * s.module_rate_hz) + 1;
  for (int n = 0; n < count; ++n) {
    const double t = n / s.module_rate_hz + (n > 0 ? noise.uniform(-3e-5, 3e-5) : 0.0);
    ModuleReading r{t, trace.at(trace.input_angle_rad, t), trace.at(trace.output_angle_rad, t),
                    trace.at(trace.current_a, t)};
    for (const auto& e : rig.effects)
      if (is_nameless(e)) apply_odd_sensor(e, r);
    r.current_a += (offset ? offset->at("offset_a") : 0.0) + s.noise.current_rms_a * noise.normal();
    const double winding =
        trace.at(trace.winding_c, t) + s.noise.temperature_rms_c * noise.normal();
    const double spring = trace.at(trace.spring_c, t) + s.noise.temperature_rms_c * noise.normal();
    const double host = link.arrival(t);
    if (link.lost()) continue;
    rows.push_back({t, s.module_clock.stamp(t), host,
                    encoder(r.input_angle_rad + s.deflection_offset_rad, s),
                    encoder(r.output_angle_rad, s), quantised(r.current_a, s.current_step_a),
                    winding, spring});
  }
  return rows;
}

std::vector<LoadcellRow> observe_loadcell(const Trace& trace, const Rig& rig, const Sensing& s) {
  const Random random(s.seed);
  LoadcellNoise noise(s.noise, s.torque_rms_nm, random.fork("loadcell noise"));
  Link link(s.loadcell_link, random.fork("loadcell link"));
  std::vector<LoadcellRow> rows;
  const double first = 0.0032;  // the board was not started with the module
  const auto count = static_cast<int>((rig.duration_s - first) * s.loadcell_rate_hz);
  for (int n = 0; n < count; ++n) {
    const double t = first + n / s.loadcell_rate_hz;
    const double torque = trace.at(trace.loadcell_torque_nm, t);
    const double read = torque + s.loadcell_offset_nm + noise.next(t, torque);
    const double host = link.arrival(t);
    if (link.lost()) continue;
    rows.push_back({t, s.loadcell_clock.stamp(t), host, n,
                    quantised(read / rig.base.lever_arm_m, s.force_step_n)});
  }
  return rows;
}

}  // namespace

Recording observe(const Trace& trace, const Rig& rig, const Sensing& sensing) {
  return {observe_module(trace, rig, sensing), observe_loadcell(trace, rig, sensing)};
}

}  // namespace searig::proving
