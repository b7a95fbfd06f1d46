#include "app/rig/estimate_stream.h"

#include <algorithm>
#include <utility>

#include "estimator/model/predict.h"

namespace searig::app {
namespace {

using estimator::ModuleSignals;

/// More than the half width over which the drive model differentiates angles, so that a sample's
/// torque does not depend on where a window was cut.
constexpr double margin_s = 0.05;

std::size_t index_at(const std::vector<double>& t_s, double at) {
  return static_cast<std::size_t>(std::lower_bound(t_s.begin(), t_s.end(), at) - t_s.begin());
}

}  // namespace

estimator::OnlineOptions start_from(const estimator::Model& model, double otherwise_nm_per_rad) {
  estimator::OnlineOptions options;
  options.initial_k_nm_per_rad =
      model.get("spring.linear", "k_nm_per_rad").value_or(otherwise_nm_per_rad);
  return options;
}

EstimateStream::EstimateStream(estimator::Model model, const estimator::OnlineOptions& options)
    : model_(std::move(model)), filter_(options) {}

void EstimateStream::follow(const ModuleSignals& module, bool ended,
                            std::vector<estimator::OnlineEstimate>& estimates) {
  const auto& t_s = module.t_s;
  if (t_s.empty()) return;
  const std::size_t until = ended ? t_s.size() : index_at(t_s, t_s.back() - margin_s);
  if (until <= followed_) return;
  const std::size_t first = index_at(t_s, t_s[followed_] - margin_s);
  const std::size_t last = std::min(t_s.size(), index_at(t_s, t_s[until - 1] + margin_s) + 1);
  take(estimator::rows_of(module, first, last), followed_ - first, until - first, estimates);
  followed_ = until;
}

void EstimateStream::take(const ModuleSignals& window, std::size_t first, std::size_t last,
                          std::vector<estimator::OnlineEstimate>& estimates) {
  const auto drive_nm = estimator::predict(model_, window).drive_nm;
  if (drive_nm.empty() || window.deflection_rad.empty()) return;
  for (std::size_t i = first; i < last; ++i) {
    filter_.push(window.t_s[i], window.deflection_rad[i], drive_nm[i]);
    while (const auto estimate = filter_.next()) estimates.push_back(*estimate);
  }
}

}  // namespace searig::app
