#include "estimator/diagnosis/rows/reduced_motion.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/rows/sampler.h"
#include "estimator/kinematics.h"
#include "estimator/model/predict.h"
#include "estimator/order.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

constexpr double rate_limit_hz = 300.0;

double range(const std::vector<double>& x) {
  const auto [low, high] = std::ranges::minmax_element(x);
  return x.empty() ? 0.0 : *high - *low;
}

void thin_out(Motion& m, std::size_t every) {
  const auto thin = [every](std::vector<double>& x) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < x.size(); i += every) x[kept++] = x[i];
    x.resize(kept);
  };
  for (auto* x : {&m.t, &m.theta, &m.theta_rate, &m.theta_accel, &m.q_i, &m.w, &m.a, &m.q_o, &m.w_o,
                  &m.a_o, &m.current, &m.winding_c, &m.spring_c})
    thin(*x);
}

/// Over the samples that thinning would drop.
void average(std::vector<double>& x, std::size_t every) {
  if (every < 2 || x.empty()) return;
  std::vector<double> sum(x.size() + 1, 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) sum[i + 1] = sum[i] + x[i];
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t from = i - std::min(i, every / 2);
    const std::size_t to = std::min(x.size(), from + every + 1 - every % 2);
    x[i] = (sum[to] - sum[from]) / double(to - from);
  }
}

/// Where current is held against angles it passes the same filter as they: what one filter takes
/// from both sides of an equation does not look like inertia or friction. Held against a load cell,
/// which passes none, it is only averaged over what thinning would drop.
void filter_current(Motion& m, const std::vector<double>& t, std::size_t every) {
  if (m.has_spring() && !m.current.empty())
    m.current = differentiate(t, m.current, differentiator_half_width_s).value;
  else
    average(m.current, every);
}

/// Rubber and windings warm over many seconds; what a temperature reads beyond that is its noise.
void calm_temperatures(Motion& m) {
  constexpr double window_s = 2.0;
  if (m.t.back() < 2.0 * window_s) return;
  std::vector<double> centres = m.t;
  for (double& t : centres) t = std::clamp(t, window_s / 2, m.t.back() - window_s / 2);
  const Sampler mean(m.t, centres, window_s);
  for (auto* x : {&m.winding_c, &m.spring_c}) {
    if (x->empty()) continue;
    const Eigen::VectorXd calm = mean(as_array(*x).matrix());
    x->assign(calm.begin(), calm.end());
  }
}

}  // namespace

Motion reduced_motion(const Signals& signals) {
  Motion m = motion_of(signals.module, differentiator_half_width_s);
  m.gear_ratio = signals.gear_ratio;
  // A clamped output moves by its encoder's rounding only: nothing can be said over its angle.
  if (range(m.q_o) < 0.1 * range(m.theta)) m.q_o.clear(), m.w_o.clear(), m.a_o.clear();
  const auto every =
      std::max<std::size_t>(1, std::size_t(std::lround(1.0 / (median_step(m.t) * rate_limit_hz))));
  filter_current(m, signals.module.t_s, every);
  thin_out(m, every);
  calm_temperatures(m);
  return m;
}

}  // namespace searig::estimator
