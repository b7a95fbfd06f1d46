#include "estimator/evaluation/survey.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "estimator/evaluation/stream_sampler.h"
#include "estimator/filter/paper_models.h"
#include "estimator/filter/size.h"
#include "estimator/kinematics.h"
#include "estimator/order.h"

namespace searig::estimator {
namespace {

constexpr double half_width_s = 0.02;         // of the window for the deflection's rate
constexpr double longest_gap = 10;            // telemetry intervals over which to interpolate
constexpr std::size_t usual_steps = 100'000;  // rows at the front that say what a usual step is

/// For a weight whose gamma is not known yet: deflection and rate of the row before a time, their
/// product at the row after it, and how far the time lies between the two.
struct About {
  double theta = 0, rate = 0, product_after = 0, u = 0;

  About() = default;
  About(const Derivatives& before, const Derivatives& after, double how_far)
      : theta(before.value),
        rate(before.first),
        product_after(after.value * after.first),
        u(how_far) {}
};

/// What weighs the load cell's samples: worked out at the rows next to them and nowhere else.
class WeightSampler {
 public:
  explicit WeightSampler(std::span<const double> at) : at_(at) { about_.reserve(at.size()); }

  /// The next row, i of the block.
  void push(const TelemetryBlock& block, std::size_t i) {
    const ModuleSignals& rows = block.rows;
    const double t = rows.t_s[i];
    while (about_.size() < at_.size() && at_[about_.size()] < t) {
      const double at = at_[about_.size()];
      if (!any_)
        about_.push_back({});
      else
        about_.push_back({i == block.from ? last_ : derivatives(rows, i - 1), derivatives(rows, i),
                          (at - t_) / (t - t_)});
    }
    t_ = t, any_ = true;
    if (i + 1 == block.to) last_ = derivatives(rows, i);
  }

  std::vector<About> finish() {
    about_.resize(at_.size(), About{last_, last_, 0});  // at the last row, if anywhere
    return std::move(about_);
  }

 private:
  static Derivatives derivatives(const ModuleSignals& rows, std::size_t i) {
    return derivatives_at(rows.t_s, rows.deflection_rad, i, half_width_s);
  }

  std::span<const double> at_;
  std::vector<About> about_;
  Derivatives last_;  // of the last row of a block
  double t_ = 0;
  bool any_ = false;
};

/// (3), with gamma at the size of the recording as it is at these samples.
std::vector<double> weights_of(const std::vector<About>& about) {
  double theta = 0, rate = 0;
  for (const About& a : about) theta += std::abs(a.theta), rate += std::abs(a.rate);
  const double n = static_cast<double>(about.size());
  const Size size{paper_size.torque_nm, theta / n, rate / n, paper_size.step_s};
  const double gamma =
      PaperUnits{paper_gamma_rad2_per_s, paper_alpha, paper_beta}.scaled_to(size).gamma;
  std::vector<double> weights;
  for (const About& a : about) {
    const double before = trust_weight(a.theta, a.rate, gamma);
    const double after = trust_weight(a.product_after, 1.0, gamma);
    weights.push_back(before + a.u * (after - before));
  }
  return weights;
}

LoadcellSignals in_order(const LoadcellSignals& given) {
  if (std::ranges::is_sorted(given.t_s)) return given;
  std::vector<std::size_t> order(given.t_s.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return given.t_s[i]; });
  LoadcellSignals out;
  for (const std::size_t i : order) {
    out.t_s.push_back(given.t_s[i]);
    out.torque_nm.push_back(given.torque_nm[i]);
  }
  return out;
}

template <class T>
void keep(const std::vector<bool>& covered, std::vector<T>& values) {
  if (values.empty()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < covered.size(); ++i)
    if (covered[i]) values[kept++] = values[i];
  values.resize(kept);
}

}  // namespace

Survey survey_of(const Telemetry& telemetry, const LoadcellSignals& as_given, Weights weights) {
  Survey out;
  out.loadcell = in_order(as_given);
  const LoadcellSignals& loadcell = out.loadcell;
  StreamGaps gaps(loadcell.t_s);
  StreamSampler deflection(loadcell.t_s), current(loadcell.t_s);
  std::optional<WeightSampler> trust;
  std::vector<double> front_s;
  telemetry.go_through(half_width_s, [&](const TelemetryBlock& block) {
    const ModuleSignals& rows = block.rows;
    out.has_deflection = !rows.deflection_rad.empty();
    out.has_current = !rows.current_a.empty();
    out.has_input_motion = !rows.input_angle_rad.empty() || !rows.input_velocity_rad_s.empty();
    const bool weigh = weights == Weights::wanted && out.has_deflection && out.has_current;
    if (weigh && !trust) trust.emplace(loadcell.t_s);
    for (std::size_t i = block.from; i < block.to; ++i) {
      const double t = rows.t_s[i];
      if (out.rows++ == 0) out.first_s = t;
      out.last_s = t;
      if (front_s.size() <= usual_steps) front_s.push_back(t);
      gaps.push(t);
      if (out.has_deflection) deflection.push(t, rows.deflection_rad[i]);
      if (out.has_current) current.push(t, rows.current_a[i]);
      if (weigh) trust->push(block, i);
    }
  });

  if (out.has_deflection) out.deflection_rad = deflection.finish();
  if (out.has_current) out.current_a = current.finish();
  if (out.rows < 2) return out;
  const double longest_s = longest_gap * median_step(front_s);
  const std::vector<double> gap = gaps.finish();
  std::vector<bool> covered(gap.size());
  for (std::size_t i = 0; i < gap.size(); ++i)
    covered[i] = gap[i] <= longest_s && std::isfinite(loadcell.torque_nm[i]);
  for (auto* values :
       {&out.loadcell.t_s, &out.loadcell.torque_nm, &out.deflection_rad, &out.current_a})
    keep(covered, *values);
  if (!trust) return out;
  std::vector<About> about = trust->finish();
  keep(covered, about);
  out.weights = weights_of(about);
  return out;
}

}  // namespace searig::estimator
