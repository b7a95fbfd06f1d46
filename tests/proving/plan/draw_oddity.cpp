#include "tests/proving/plan/draw_oddity.h"

#include <cmath>
#include <stdexcept>

namespace searig::proving {

Effect draw_oddity(const std::string& form, const Rig& rig, const Statistics& s, Random r) {
  const double torque = 0.04 * s.torque_rms_nm;
  const double from = r.uniform(0.25, 0.65) * rig.duration_s;
  const double to = from + r.uniform(0.1, 0.25) * rig.duration_s;
  const auto made = [&](const std::string& words, std::map<std::string, double> parameters,
                        std::vector<std::string> amplitude) {
    return Effect{"no name: " + words, form, std::move(parameters), std::move(amplitude), {}};
  };
  if (form == "snag")
    return made("a snag at one angle in one direction",
                {{"torque_nm", 3 * torque},
                 {"centre_rad", r.uniform(-0.25, 0.25) * s.input_peak_rad},
                 {"width_rad", r.uniform(0.03, 0.07) * s.input_peak_rad}},
                {"torque_nm"});
  if (form == "quadratic_drag")
    return made("drag that grows with the square of velocity",
                {{"nm_s2_per_rad2", 2 * torque / std::pow(s.velocity_rms_rad_s, 2)}},
                {"nm_s2_per_rad2"});
  if (form == "speed_chatter")
    return made("extra drag in one band of speed",
                {{"torque_nm", 2 * torque},
                 {"centre_rad_s", r.uniform(0.7, 1.1) * s.velocity_rms_rad_s},
                 {"width_rad_s", 0.1 * s.velocity_rms_rad_s}},
                {"torque_nm"});
  if (form == "backlash_click")
    return made("a blow each time the torque changes sign",
                {{"torque_nm", 4 * torque}, {"lasts_s", r.uniform(0.01, 0.02)}}, {"torque_nm"});
  if (form == "slip_event")
    return made("dry friction that comes and goes",
                {{"torque_nm", 2 * torque}, {"from_s", from}, {"to_s", to}}, {"torque_nm"});
  if (form == "detent")
    return made("a notch at one deflection",
                {{"torque_nm", 3 * torque},
                 {"centre_rad", r.sign() * r.uniform(0.4, 1.0) * s.deflection_rms_rad},
                 {"width_rad", r.uniform(0.08, 0.15) * s.deflection_rms_rad}},
                {"torque_nm"});
  if (form == "periodic_bearing_friction")
    return made("friction that depends on where the output stands",
                {{"torque_nm", 2 * torque},
                 {"cycles_per_rad", r.uniform(4.0, 9.0) / s.output_peak_rad},
                 {"smoothing_rad_s", 0.05 * s.rate_rms_rad_s}},
                {"torque_nm"});
  if (form == "plastic_yield")
    return made("the spring takes a permanent set",
                {{"set_rad", r.sign() * 0.04 * s.deflection_rms_rad}, {"from_s", from}},
                {"set_rad"});
  if (form == "zero_random_walk")
    return made("a load-cell zero that wanders at random",
                {{"nm_per_sqrt_s", torque / std::sqrt(0.2 * rig.duration_s)},
                 {"seed", std::floor(r.uniform(1.0, 1e9))}},
                {"nm_per_sqrt_s"});
  if (form == "frozen_reading")
    return made("the load cell repeats its last value",
                {{"from_s", from}, {"to_s", from + r.uniform(1.5, 4.0)}}, {});
  if (form == "zero_step")
    return made("the load cell's zero jumps", {{"torque_nm", r.sign() * torque}, {"from_s", from}},
                {"torque_nm"});
  if (form == "saturation")
    return made("the load cell saturates on one side",
                {{"peak_nm", s.torque_peak_nm}, {"depth_share", 0.35}}, {"depth_share"});
  if (form == "gain_fault")
    return made("the load cell reads too little for a while",
                {{"share", 0.08}, {"from_s", from}, {"to_s", to}}, {"share"});
  if (form == "cable_tremor")
    return made(
        "a cable swings while the load cell is touched",
        {{"torque_nm", 3 * torque}, {"hz", r.uniform(4.0, 8.0)}, {"from_s", from}, {"to_s", to}},
        {"torque_nm"});
  if (form == "missing_codes")
    return made("a converter that skips codes in one band",
                {{"low_nm", 0.3 * s.torque_rms_nm},
                 {"high_nm", 1.5 * s.torque_rms_nm},
                 {"code_nm", 4 * torque}},
                {"code_nm"});
  if (form == "encoder_eccentricity")
    return made("a wave in the input encoder",
                {{"amplitude_rad", 0.04 * s.deflection_rms_rad},
                 {"cycles_per_rad", r.uniform(5.0, 14.0)},
                 {"phase_rad", r.uniform(0.0, 6.28)}},
                {"amplitude_rad"});
  if (form == "encoder_slip")
    return made("the input encoder loses counts once",
                {{"jump_rad", r.sign() * 0.04 * s.deflection_rms_rad}, {"from_s", from}},
                {"jump_rad"});
  if (form == "current_sensor_fault")
    return made("the current reads too little for a while",
                {{"share", 0.1}, {"from_s", from}, {"to_s", to}}, {"share"});
  throw std::invalid_argument("no oddity has the form " + form);
}

}  // namespace searig::proving
