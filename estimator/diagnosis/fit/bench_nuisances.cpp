// Bench: what is always refitted beside a hypothesis.
#include <cmath>

#include "estimator/diagnosis/fit/bench.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

/// First to fourth derivative with respect to time of a signal, as a window of `width` sees it.
Eigen::MatrixXd derivatives(const std::vector<double>& t, const std::vector<double>& at,
                            double width, const Eigen::VectorXd& x) {
  const double h = 0.5 * width;
  Eigen::MatrixXd shifted(Eigen::Index(at.size()), 5);
  for (int i = 0; i < 5; ++i) shifted.col(i) = Sampler(t, at, width, (i - 2) * h)(x);
  Eigen::Matrix<double, 5, 4> stencil;
  stencil << 1, -1, -6, 1,  //
      -8, 16, 12, -4,       //
      0, -30, 0, 6,         //
      8, 16, -12, -4,       //
      -1, -1, 6, 1;
  stencil.col(0) /= 12 * h;
  stencil.col(1) /= 12 * h * h;
  stencil.col(2) /= 12 * h * h * h;
  stencil.col(3) /= h * h * h * h;
  return shifted * stencil;
}

}  // namespace

/// What is seen differs from the torque by a filter that nobody declared. To fourth order in time
/// that is a delay, a width, a skew and a kurtosis: T + c1 dT/dt + ... + c4 d4T/dt4. Each has a
/// prior of what averaging over one window more or less would do; where the load cell is known to
/// be late, of so long a window, for in which form it is late nobody knows.
Eigen::MatrixXd Bench::nuisances() const {
  const Experiment& e = experiment_;
  const Motion& m = e.motion;
  const Eigen::Index split = e.loadcell_rows(), rows = e.rows();
  const auto offsets = Eigen::Index(e.part_starts_s.size());
  const Eigen::MatrixXd adapting = adapting_stiffness();
  Eigen::MatrixXd out =
      Eigen::MatrixXd::Zero(total_rows(), adapting.cols() + offsets + prior_count);
  out.leftCols(adapting.cols()) = adapting;
  for (Eigen::Index i = 0; i < (e.has_spring() ? split : rows); ++i)
    out(i, adapting.cols() + Eigen::Index(e.part(i))) = 1.0;  // the load cell's offset
  auto held = out.rightCols(prior_count);
  if (e.has_spring()) {
    const double w = std::hypot(e.loadcell_width_s, late_s_);
    const double sd[4] = {e.clock_sd_s, w * w / 8.0, w * w * w / 24.0, w * w * w * w / 128.0};
    const Eigen::MatrixXd d = derivatives(m.t, e.loadcell_t, e.loadcell_width_s, torque_);
    for (int i = 0; i < 4; ++i) held.col(i).head(split) = d.col(i) * sd[i];
  }
  if (e.has_drive()) {
    const double step = m.t.back() / double(m.size() - 1);
    const Eigen::VectorXd torque = e.has_spring() ? torque_ : as_array(m.spring_nm).matrix();
    const Eigen::MatrixXd d = derivatives(m.t, e.drive_t, e.drive_width_s, torque);
    held.col(4).segment(split, e.drive_rows()) = d.col(0) * 0.1 * step;
    held.col(5).segment(split, e.drive_rows()) = d.col(1) * step * step;
  }
  for (Eigen::Index i = 0; i < prior_count; ++i)  // unit prior: coefficients count in sd's
    if (held.col(i).squaredNorm() > 0) held(rows + i, i) = 1.0;
  return out;
}

/// Changes of the stiffness at knots in time, straight in between; no columns where it stays.
Eigen::MatrixXd Bench::adapting_stiffness() const {
  const Motion& m = experiment_.motion;
  if (method_.stiffness_stays || !experiment_.has_spring()) return Eigen::MatrixXd(total_rows(), 0);
  const Eigen::ArrayXd t = as_array(m.t) / Method::adapting_s, theta = as_array(m.theta);
  Eigen::MatrixXd features(Eigen::Index(m.size()), Eigen::Index(t.maxCoeff()));
  for (Eigen::Index knot = 0; knot < features.cols(); ++knot)
    features.col(knot) = (theta * (1.0 - (t - double(knot)).abs()).max(0.0)).matrix();
  return stack(Path::spring, features, 0.0, 0.0);
}

}  // namespace searig::estimator
