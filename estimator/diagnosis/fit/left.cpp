#include "estimator/diagnosis/fit/left.h"

#include <algorithm>
#include <cmath>

namespace searig::estimator {

double Left::power() const {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < residual.size(); ++i)
    if (usable[std::size_t(i)]) sum += residual[i] * residual[i];
  return sum;
}

double Left::rms() const {
  const auto rows = std::ranges::count(usable, true);
  return rows > 0 ? std::sqrt(power() / double(rows)) : 0.0;
}

double Left::badness() const {
  const double rows = double(std::ranges::count(usable, true));
  return 2.0 * rows * std::log(fit_autoregression(residual, usable, Whitening::order).sd);
}

Left left_of(const Bench& bench, const Eigen::VectorXd& residual, bool drive) {
  const Experiment& e = bench.experiment();
  const Eigen::Index from = drive ? e.loadcell_rows() : 0,
                     to = drive ? e.rows() : e.loadcell_rows();
  return {residual.segment(from, to - from), {e.usable.begin() + from, e.usable.begin() + to}};
}

}  // namespace searig::estimator
