#include "tests/proving/truth/reachable.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tests/proving/rig/oddity.h"
#include "tests/proving/truth/smoother.h"

namespace searig::proving {
namespace {

constexpr double moving_rad_s = 0.03;     // contract: below it current says nothing about torque
constexpr double smoothing_rad_s = 0.01;  // of the owner's Coulomb term
constexpr double block_s = 10.0;

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// The baseline's regressors at one instant, the concealed ones left out.
Vector drive_regressors(double current, double acceleration, double velocity, const Rig& rig,
                        const Concealed& hidden) {
  Vector x = Vector::Zero(4);
  x[0] = rig.base.efficiency * current;
  if (!hidden.inertia) x[1] = -rig.base.efficiency * acceleration;
  if (!hidden.coulomb) x[2] = -std::tanh(velocity / smoothing_rad_s);
  if (!hidden.viscous) x[3] = -velocity;
  return x;
}

struct Problem {
  Matrix x;
  Vector y;
  std::vector<double> t_s;
};

Vector solve(const Matrix& x, const Vector& y) {
  Matrix normal = x.transpose() * x;
  for (Eigen::Index i = 0; i < normal.rows(); ++i)  // a concealed column is zero: keep it out
    if (normal(i, i) == 0.0) normal(i, i) = 1.0;
  return normal.ldlt().solve(x.transpose() * y);
}

/// Root mean square of what a fit to the other blocks leaves in each block.
double held_out_rms(const Problem& p, double duration_s) {
  const int blocks = std::max(2, static_cast<int>(std::lround(duration_s / block_s)));
  double squares = 0.0;
  for (int b = 0; b < blocks; ++b) {
    Vector weight(p.y.size());
    for (Eigen::Index i = 0; i < p.y.size(); ++i)
      weight[i] =
          static_cast<int>(p.t_s[static_cast<std::size_t>(i)] / duration_s * blocks) == b ? 0 : 1;
    const Vector fit = solve(weight.asDiagonal() * p.x, weight.asDiagonal() * p.y);
    const Vector left = (Vector::Ones(weight.size()) - weight).asDiagonal() * (p.y - p.x * fit);
    squares += left.squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(std::max<Eigen::Index>(1, p.y.size())));
}

/// What the module's sensors show that is not there.
ModuleReading sensor_error(const Trace& trace, const Rig& rig, double t) {
  const double q_i = trace.at(trace.input_angle_rad, t), i = trace.at(trace.current_a, t);
  ModuleReading r{t, q_i, 0.0, i};
  for (const auto& e : rig.effects)
    if (is_nameless(e)) apply_odd_sensor(e, r);
  const Effect* offset = rig.find("drive.current_offset");
  return {t, r.input_angle_rad - q_i, 0.0,
          r.current_a - i + (offset ? offset->at("offset_a") : 0.0)};
}

/// The torque that the owner's drive equation would give if its numbers were true.
double owned_drive_torque(const Trace& trace, const Rig& rig, const Concealed& hidden, double t) {
  const Baseline& b = rig.base;
  double torque = b.efficiency * b.torque_constant_nm_per_a * trace.at(trace.current_a, t);
  if (!hidden.inertia)
    torque -= b.efficiency * b.inertia_kg_m2 * trace.at(trace.input_acceleration_rad_s2, t);
  if (!hidden.coulomb) torque += trace.at(trace.coulomb_nm, t);
  if (!hidden.viscous) torque -= b.viscous_nm_s_per_rad * trace.at(trace.input_velocity_rad_s, t);
  return torque;
}

struct Measured {
  std::vector<double> t_s, torque_nm;
  Smoothed deflection, input, current;
};

Measured at_loadcell_times(const Recording& r, const Rig& rig, const Sensing& s) {
  std::vector<double> t, deflection, angle, current;
  for (const auto& m : r.module) {
    t.push_back(m.true_s), deflection.push_back(m.input_angle_rad - m.output_angle_rad);
    angle.push_back(m.input_angle_rad), current.push_back(m.current_a);
  }
  Measured out;
  for (const auto& l : r.loadcell) {
    if (l.true_s > t.back()) break;
    out.t_s.push_back(l.true_s);
    out.torque_nm.push_back(l.force_n * rig.base.lever_arm_m);
  }
  const double fine = std::max(0.005, 1.2 / s.module_rate_hz), coarse = std::max(0.010, fine);
  out.deflection = smooth_at(out.t_s, t, deflection, fine);
  out.input = smooth_at(out.t_s, t, angle, coarse);
  out.current = smooth_at(out.t_s, t, current, coarse);
  return out;
}

Problem select(const Matrix& x, const Vector& y, const std::vector<double>& t,
               const std::vector<bool>& keep) {
  const auto rows = std::count(keep.begin(), keep.end(), true);
  Problem p{Matrix(rows, x.cols()), Vector(rows), {}};
  Eigen::Index n = 0;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    p.x.row(n) = x.row(static_cast<Eigen::Index>(i));
    p.y[n++] = y[static_cast<Eigen::Index>(i)];
    p.t_s.push_back(t[i]);
  }
  return p;
}

}  // namespace

Concealed Concealed::from(const std::vector<Effect>& effects) {
  Concealed c;
  for (const auto& e : effects) {
    c.coulomb |= e.name == "drive.coulomb";
    c.viscous |= e.name == "drive.viscous";
    c.inertia |= e.name == "drive.inertia";
  }
  return c;
}

double Reachable::rho() const {
  const auto over = [](const BeforeAfter& p) {
    return p.after > 0.0
               ? std::sqrt(std::max(0.0, p.before * p.before - p.after * p.after)) / p.after
               : 0.0;
  };
  return std::max(over(spring), over(drive));
}

Reachable reachable(const Trace& trace, const Rig& rig, const Sensing& sensing,
                    const Recording& recording, const Concealed& hidden) {
  const Measured m = at_loadcell_times(recording, rig, sensing);
  const auto rows = static_cast<Eigen::Index>(m.t_s.size());
  Matrix spring(rows, 2), drive(rows, 4);
  Vector y(rows), spring_after(rows), drive_before(rows), drive_after(rows);
  std::vector<bool> moving(m.t_s.size()), all(m.t_s.size(), true);
  for (std::size_t n = 0; n < m.t_s.size(); ++n) {
    const auto i = static_cast<Eigen::Index>(n);
    const double t = m.t_s[n], true_reading = trace.at(trace.loadcell_torque_nm, t);
    const ModuleReading fault = sensor_error(trace, rig, t);
    spring.row(i) << m.deflection.value[n], 1.0;
    drive.row(i) =
        drive_regressors(m.current.value[n], m.input.acceleration[n], m.input.rate[n], rig, hidden);
    moving[n] = std::abs(m.input.rate[n]) > moving_rad_s;
    y[i] = m.torque_nm[n];
    const double linear =
        trace.at(trace.linear_torque_nm, t) + rig.base.stiffness_nm_per_rad * fault.input_angle_rad;
    spring_after[i] = y[i] - true_reading + linear;
    drive_before[i] = y[i] - sensing.loadcell_offset_nm;  // a number: the owner can weigh nothing
    drive_after[i] = drive_before[i] - true_reading + owned_drive_torque(trace, rig, hidden, t) +
                     rig.base.efficiency * rig.base.torque_constant_nm_per_a * fault.current_a;
  }
  const auto held_out = [&](const Matrix& x, const Vector& v, const std::vector<bool>& keep) {
    return held_out_rms(select(x, v, m.t_s, keep), rig.duration_s);
  };
  Reachable out;
  out.spring = {held_out(spring, y, all), held_out(spring, spring_after, all)};
  out.drive = {held_out(drive, drive_before, moving), held_out(drive, drive_after, moving)};
  const Vector k = solve(spring, y);
  const Problem p = select(drive, drive_before, m.t_s, moving);
  const Vector d = solve(p.x, p.y);
  out.fitted = {k[0], k[1], d[0], d[0] > 0 ? d[1] : 0.0, d[2], d[3]};
  return out;
}

double visible_strength(const Trace& trace, const Rig& rig, const Recording& recording,
                        const Concealed& hidden, const Reachable& floor, double slack_s) {
  // Columns: k, offset | torque constant, inertia, coulomb, viscous | clock shift, shared.
  std::vector<double> times;
  for (const auto& l : recording.loadcell)
    if (l.true_s < rig.duration_s - 0.1 && l.true_s > 0.1) times.push_back(l.true_s);
  const auto rows = static_cast<Eigen::Index>(times.size());
  Matrix x = Matrix::Zero(2 * rows, 6);
  Vector y = Vector::Zero(2 * rows), shift = Vector::Zero(2 * rows);
  double moving = 0.0;
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double t = times[static_cast<std::size_t>(i)];
    const ModuleReading fault = sensor_error(trace, rig, t);
    const double reading = trace.at(trace.loadcell_torque_nm, t), h = 2e-3;
    const double slope =
        (trace.at(trace.loadcell_torque_nm, t + h) - trace.at(trace.loadcell_torque_nm, t - h)) /
        (2 * h);
    const double one = 1.0 / floor.spring.after, two = 1.0 / floor.drive.after;
    const double theta = trace.at(trace.input_angle_rad, t) - trace.at(trace.output_angle_rad, t);
    x(i, 0) = one * (theta + fault.input_angle_rad), x(i, 1) = one;
    y[i] = one * reading, shift[i] = one * slope;
    const double w = trace.at(trace.input_velocity_rad_s, t);
    if (std::abs(w) < moving_rad_s) continue;
    moving += 1.0;
    x.row(rows + i).tail(4) =
        two * drive_regressors(trace.at(trace.current_a, t) + fault.current_a,
                               trace.at(trace.input_acceleration_rad_s2, t), w, rig, hidden)
                  .transpose();
    y[rows + i] = two * reading, shift[rows + i] = two * slope;
  }
  Matrix with_shift(2 * rows, 7);
  with_shift << x, shift;
  const double best = solve(with_shift, y)[6];
  const Vector rest = y - std::clamp(best, -slack_s, slack_s) * shift;
  const Vector left = rest - x * solve(x, rest);
  const double spring = std::sqrt(left.head(rows).squaredNorm() / static_cast<double>(rows));
  const double drive = std::sqrt(left.tail(rows).squaredNorm() / std::max(1.0, moving));
  return std::max(spring, drive);
}

}  // namespace searig::proving
