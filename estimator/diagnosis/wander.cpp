#include "estimator/diagnosis/remainder.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/locate.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
std::optional<Unexplained> wanders(const Bench& bench, const Hypothesis& hypothesis) {
  const Experiment& e = bench.experiment();
  const Eigen::VectorXd raw = bench.raw_residual(hypothesis, bench.fit(hypothesis));
  const auto means = [&](double seconds) {
    std::vector<double> out;
    double sum = 0.0, n = 0.0, block = 0.0;
    for (Eigen::Index i = 0; i < e.loadcell_rows(); ++i) {
      if (!e.usable[std::size_t(i)]) continue;
      if (std::floor(e.time(i) / seconds) != block) {
        if (n > 0) out.push_back(sum / n);
        sum = n = 0.0, block = std::floor(e.time(i) / seconds);
      }
      sum += raw[i], n += 1.0;
    }
    return out;
  };
  const auto square = [](const std::vector<double>& x) {
    double sum = 0.0;
    for (const double v : x) sum += v * v;
    return x.empty() ? 0.0 : sum / double(x.size());
  };
  double total = 0.0, n = 0.0;
  for (Eigen::Index i = 0; i < e.loadcell_rows(); ++i)
    if (e.usable[std::size_t(i)]) total += raw[i] * raw[i], n += 1.0;
  const double slow = square(means(8.0));
  if (n < 200 || slow < 0.3 * total / n || slow < 0.5 * square(means(2.0))) return std::nullopt;
  Unexplained out;
  out.located.residuals = residuals_of(Path::rig);
  out.located.intervals_s = {{e.start_s, e.start_s + e.motion.t.back()}};
  out.located.share = slow / (total / n);
  // Chernoff's bound for a mean of squares, were a fifth of the power that slow anyway.
  const double x = slow / (0.2 * total / n), m = double(means(8.0).size());
  out.p_value = x > 1.0 ? std::exp(-0.5 * m * (x - 1.0 - std::log(x))) : 1.0;
  out.what = "the load cell's zero wanders";
  return out;
}

}  // namespace searig::estimator
