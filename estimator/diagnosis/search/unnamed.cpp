#include "estimator/diagnosis/search/unnamed.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/search/atom_collector.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

using Array = Eigen::ArrayXd;

Array smooth_sign(const std::vector<double>& rate) {
  return (as_array(rate) / std::max(1e-12, 0.05 * rms(rate))).tanh();
}

void in_the_spring(const Motion& m, AtomCollector& c) {
  const auto theta = as_array(m.theta), rate = as_array(m.theta_rate);
  c.bumps(m.theta, "deflection_rad", Path::spring, 9);
  c.hinges(m.theta, "deflection_rad", Path::spring);
  c.shaped("drag that grows with the square of the rate", Path::spring, "deflection_rate_rad_s",
           m.theta_rate, rate * rate.abs());
  c.shaped("an even part that grows with the square of the deflection", Path::spring,
           "deflection_rad", m.theta, theta.square());
  c.shaped("a stiffness that depends on speed", Path::spring, "deflection_rate_rad_s", m.theta_rate,
           theta * rate.abs());
  c.events("the zero of the deflection jumps", Path::spring, Array::Ones(theta.size()), 24);
  c.events("the stiffness jumps", Path::spring, theta, 24);
  c.episodes(Path::spring, 18, theta);
  if (!m.q_o.empty()) {
    c.waves(m.q_o, "output_angle_rad", Path::spring, 6);
    c.bumps(m.q_o, "output_angle_rad", Path::spring, 8);
    c.shaped("a stiffness that depends on the angle", Path::spring, "output_angle_rad", m.q_o,
             theta * as_array(m.q_o));
  }
  if (!m.q_i.empty()) c.waves(m.q_i, "input_angle_rad", Path::spring, 6);
}

void in_the_drive(const Motion& m, AtomCollector& c) {
  const auto w = as_array(m.w), current = as_array(m.current);
  const Array sign = (w / m.smoothing_rad_s).tanh();
  c.shaped("drag that grows with the square of the velocity", Path::drive, "input_velocity_rad_s",
           m.w, w * w.abs());
  c.shaped("drag that grows with the cube of the velocity", Path::drive, "input_velocity_rad_s",
           m.w, w.cube());
  c.shaped("a drag to one side", Path::drive, "input_velocity_rad_s", m.w, w.abs());
  c.shaped("a motor that saturates", Path::drive, "current_a", m.current, current * current.abs());
  c.shaped("a motor that saturates", Path::drive, "current_a", m.current, current.cube());
  c.bumps(m.w, "input_velocity_rad_s", Path::drive, 9);
  c.hinges(m.current, "current_a", Path::drive);
  c.events("the drive's torque jumps", Path::drive, Array::Ones(w.size()), 20);
  c.events("the motor's torque constant jumps", Path::drive, current, 16);
  c.events("the friction changes", Path::drive, sign, 20);
  if (m.has_spring()) {
    c.bumps(m.theta, "deflection_rad", Path::drive, 10);
    c.bumps(m.theta, "deflection_rad", Path::drive, 10, sign);
    // Play: where the torque changes sign the teeth change sides.
    c.bumps(
        m.theta, "deflection_rad", Path::drive, 10, as_array(m.a),
        "near one value the drive does not accelerate as what it drives, as with play in gears");
  }
  c.episodes(Path::drive, 16, sign);
  c.episodes(Path::drive, 12, Array::Ones(w.size()));
  if (!m.q_i.empty()) {
    c.bumps(m.q_i, "input_angle_rad", Path::drive, 8);
    c.bumps(m.q_i, "input_angle_rad", Path::drive, 6, sign);
    c.waves(m.q_i, "input_angle_rad", Path::drive, 8, sign, 0.5);
    c.waves(m.q_i, "input_angle_rad", Path::drive, 3, {}, 0.5);
  }
}

void at_the_loadcell(const Motion& m, AtomCollector& c) {
  const auto torque = as_array(m.spring_nm);
  c.hinges(m.spring_nm, "loadcell_torque_nm", Path::rig);
  c.shaped("a load cell that is not straight", Path::rig, "loadcell_torque_nm", m.spring_nm,
           torque.square());
  c.shaped("a load cell that is not straight", Path::rig, "loadcell_torque_nm", m.spring_nm,
           torque.cube());
  c.events("the load cell's zero jumps", Path::rig, Array::Ones(torque.size()), 30);
  c.events("the load cell's gain jumps", Path::rig, torque, 16);
  c.episodes(Path::rig, 24, Array::Ones(torque.size()));
  c.episodes(Path::rig, 12, torque);
  if (m.q_o.empty()) return;
  const auto w_o = as_array(m.w_o);
  c.shaped("friction at the output", Path::rig, "output_velocity_rad_s", m.w_o, smooth_sign(m.w_o));
  c.shaped("drag at the output", Path::rig, "output_velocity_rad_s", m.w_o, w_o);
  c.shaped("drag at the output", Path::rig, "output_velocity_rad_s", m.w_o, w_o * w_o.abs());
  c.bumps(m.q_o, "output_angle_rad", Path::rig, 8);
  c.waves(m.q_o, "output_angle_rad", Path::rig, 6, {}, 2.0);
  c.waves(m.q_o, "output_angle_rad", Path::rig, 6, smooth_sign(m.w_o), 0.5);
}

}  // namespace

std::vector<Atom> lasting_changes(const Motion& m) {
  std::vector<Atom> out;
  AtomCollector collector(m, out);
  const Array always = Array::Ones(Eigen::Index(m.size())), torque = as_array(m.spring_nm);
  const auto add = [&](Path path, const Array& carrier) {
    collector.events("something changes", path, carrier, 2);
  };
  if (m.has_spring()) {
    add(Path::spring, as_array(m.theta));
    add(Path::rig, always);
    add(Path::rig, torque);
  }
  // A motor that gives less shows where the spring is loaded; the current itself would be a way to
  // shrink both sides of the drive's equation. Without a spring the load is what is measured.
  if (m.has_drive()) {
    add(Path::drive, always);
    add(Path::drive, (as_array(m.w) / m.smoothing_rad_s).tanh());
    add(Path::drive, m.has_spring() ? torque : Array(as_array(m.current)));
  }
  return out;
}

std::vector<Atom> unnamed_atoms(const Motion& motion) {
  std::vector<Atom> out;
  AtomCollector collector(motion, out);
  if (motion.has_spring()) in_the_spring(motion, collector);
  if (motion.has_spring()) at_the_loadcell(motion, collector);
  if (motion.has_drive()) in_the_drive(motion, collector);
  return out;
}

}  // namespace searig::estimator
