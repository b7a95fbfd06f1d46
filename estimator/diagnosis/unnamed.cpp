#include "estimator/diagnosis/unnamed.h"

#include <algorithm>
#include <cmath>

#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

using Array = Eigen::ArrayXd;

class Collector {
 public:
  Collector(const Motion& motion, std::vector<Atom>& out) : m_(motion), out_(out) {}

  using Make = std::function<Eigen::VectorXd(double from, double to)>;

  void add(std::string what, Path path, std::string channel, double from, double to,
           const Array& feature, Make at = {}) {
    if (feature.size() == 0 || !feature.allFinite() || feature.abs().maxCoeff() <= 0) return;
    out_.push_back(
        {std::move(what), path, std::move(channel), from, to, false, feature.matrix(), at});
  }

  void add(std::string what, Path path, std::string channel, double from, double to,
           const Make& at) {
    add(std::move(what), path, std::move(channel), from, to, at(from, to).array(), at);
  }

  /// Something that happens only near one value of x: a notch, a snag, a missing code.
  void bumps(const std::vector<double>& x, const std::string& channel, Path path, int count,
             const Array& carrier = {}) {
    if (x.empty()) return;
    const auto [low, high] = range(x);
    if (!(high > low)) return;
    for (const double width : {(high - low) / count, 0.35 * (high - low) / count})
      for (double c = low; c <= high; c += width)
        add("something that happens only near one value", path, channel, c - width, c + width,
            [&x, carrier](double from, double to) -> Eigen::VectorXd {
              const double centre = 0.5 * (from + to), sd = 0.25 * (to - from);
              Array bump = (-0.5 * ((as_array(x) - centre) / sd).square()).exp();
              if (carrier.size() > 0) bump *= carrier;
              return bump.matrix();
            });
  }

  /// Something that begins beyond a value of x: a stop, a snag to one side, saturation.
  void hinges(const std::vector<double>& x, const std::string& channel, Path path) {
    if (x.empty()) return;
    const auto [low, high] = range(x);
    for (const double share : {0.2, 0.4, 0.6, 0.75, 0.88, 0.94}) {
      const double up = high * share, down = low * share;
      add("something that begins beyond a value", path, channel, up, high,
          [&x](double from, double) -> Eigen::VectorXd {
            return (as_array(x) - from).max(0.0).matrix();
          });
      add("something that begins beyond a value", path, channel, low, down,
          [&x](double, double to) -> Eigen::VectorXd {
            return (as_array(x) - to).min(0.0).matrix();
          });
    }
  }

  /// A wave over an angle: an eccentric encoder, a guide that binds once per turn.
  void waves(const std::vector<double>& angle, const std::string& channel, Path path, int count,
             const Array& carrier = {}, double first = 1.0) {
    if (angle.empty()) return;
    const auto [low, high] = range(angle);
    if (!(high > low)) return;
    // Less than two thirds of a wave over the range is a constant or a slope, not a wave.
    first = std::max(first, 4.0 / (high - low));
    const double step = 0.5 * M_PI / (high - low);
    for (int i = 0; i < count; ++i)
      for (const bool cosine : {false, true}) {
        const Array x = (first + i * step) * as_array(angle);
        Array wave = (x + (cosine ? M_PI / 2 : 0.0)).sin();
        if (carrier.size() > 0) wave *= carrier;
        add("a wave over the angle", path, channel, low, high, wave);
      }
  }

  /// Something that changes at one time: a step, or another size from then on.
  void events(const std::string& what, Path path, const Array& carrier, int count) {
    const double end = m_.t.back();
    for (int i = 1; i < count; ++i) {
      const double at = end * (0.08 + 0.84 * i / count);
      add(what, path, "time_s", at, end,
          [&m = m_, carrier](double from, double to) -> Eigen::VectorXd {
            const auto t = as_array(m.t);
            return (t > from && t <= to).select(carrier, 0.0).matrix();
          });
      if (!out_.empty()) out_.back().at_once = true;
    }
  }

  /// Something that lasts for a while only.
  void episodes(Path path, int count, const Array& carrier) {
    const double end = m_.t.back();
    for (int i = 0; i < count; ++i)
      add("something that happens only for a while", path, "time_s", end * i / count,
          end * (i + 1) / count, [&m = m_, carrier](double from, double to) -> Eigen::VectorXd {
            const auto t = as_array(m.t);
            return (t > from && t <= to).select(carrier, 0.0).matrix();
          });
  }

  void shaped(std::string what, Path path, std::string channel, const std::vector<double>& x,
              const Array& feature) {
    if (x.empty()) return;
    const auto [low, high] = range(x);
    add(std::move(what), path, std::move(channel), low, high, feature);
  }

 private:
  static std::pair<double, double> range(const std::vector<double>& x) {
    const auto [low, high] = std::ranges::minmax_element(x);
    return {*low, *high};
  }

  const Motion& m_;
  std::vector<Atom>& out_;
};

Array smooth_sign(const std::vector<double>& rate) {
  return (as_array(rate) / std::max(1e-12, 0.05 * rms(rate))).tanh();
}

void in_the_spring(const Motion& m, Collector& c) {
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

void in_the_drive(const Motion& m, Collector& c) {
  const auto w = as_array(m.w), current = as_array(m.current);
  const Array sign = (w / m.smoothing_rad_s).tanh();
  c.shaped("drag that grows with the square of the velocity", Path::drive, "input_velocity_rad_s",
           m.w, w * w.abs());
  c.shaped("drag that grows with the cube of the velocity", Path::drive, "input_velocity_rad_s",
           m.w, w.cube());
  c.shaped("a drag to one side", Path::drive, "input_velocity_rad_s", m.w, w.abs());
  c.shaped("a motor that saturates", Path::drive, "current_a", m.current, current * current.abs());
  c.shaped("a motor that saturates", Path::drive, "current_a", m.current, current.cube());
  c.hinges(m.current, "current_a", Path::drive);
  c.events("the drive's torque jumps", Path::drive, Array::Ones(w.size()), 20);
  c.events("the motor's torque constant jumps", Path::drive, current, 16);
  c.events("the friction changes", Path::drive, sign, 20);
  if (m.has_spring()) {
    c.bumps(m.theta, "deflection_rad", Path::drive, 10);
    c.bumps(m.theta, "deflection_rad", Path::drive, 10, sign);
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

void at_the_loadcell(const Motion& m, Collector& c) {
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
  Collector collector(m, out);
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
  Collector collector(motion, out);
  if (motion.has_spring()) in_the_spring(motion, collector);
  if (motion.has_spring()) at_the_loadcell(motion, collector);
  if (motion.has_drive()) in_the_drive(motion, collector);
  return out;
}

}  // namespace searig::estimator
