#include "estimator/diagnosis/fit/polish.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>

namespace searig::estimator {
namespace {

/// Where a polished value lives, and how it is transformed: sizes by their logarithm, a delay as
/// is.
struct Place {
  std::size_t piece, value;
  bool logarithmic;
};

std::vector<Place> free_places(const Hypothesis& hypothesis) {
  std::vector<Place> out;
  for (std::size_t p = 0; p < hypothesis.size(); ++p) {
    if (!hypothesis[p].effect) continue;
    const auto& shape = hypothesis[p].shape;
    for (std::size_t v = 0; v < hypothesis[p].effect->free_shape(shape); ++v)
      out.push_back({p, v, hypothesis[p].effect->name() != "rig.delay"});
  }
  return out;
}

Hypothesis moved(Hypothesis hypothesis, const std::vector<Place>& places, const double* x) {
  for (std::size_t i = 0; i < places.size(); ++i)
    hypothesis[places[i].piece].shape[places[i].value] =
        places[i].logarithmic ? std::exp(x[i]) : x[i];
  return hypothesis;
}

struct Residual {
  const Bench& bench;
  const Hypothesis& start;
  const std::vector<Place>& places;

  bool operator()(double const* const* x, double* out) const {
    const Fit fit = bench.fit(moved(start, places, x[0]));
    Eigen::Map<Eigen::VectorXd>(out, fit.solution.residual.size()) = fit.solution.residual;
    return fit.solution.residual.allFinite();
  }
};

}  // namespace

Hypothesis polish(const Bench& bench, Hypothesis hypothesis, int max_iterations) {
  const auto places = free_places(hypothesis);
  if (places.empty()) return hypothesis;
  std::vector<double> x;
  for (const auto& at : places) {
    const double value = hypothesis[at.piece].shape[at.value];
    x.push_back(at.logarithmic ? std::log(value) : value);
  }
  ceres::NumericDiffOptions steps;
  steps.relative_step_size = 1e-3;
  auto* cost = new ceres::DynamicNumericDiffCostFunction<Residual, ceres::FORWARD>(
      new Residual{bench, hypothesis, places}, ceres::TAKE_OWNERSHIP, steps);
  cost->AddParameterBlock(int(x.size()));
  cost->SetNumResiduals(int(bench.total_rows()));
  ceres::Problem problem;
  problem.AddResidualBlock(cost, nullptr, x.data());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Piece& piece = hypothesis[places[i].piece];
    const auto range =
        piece.effect->shape_range(bench.experiment().motion, piece.shape, places[i].value);
    const auto put = [&](double v) { return places[i].logarithmic ? std::log(v) : v; };
    x[i] = std::clamp(x[i], put(range.lower), put(range.upper));
    problem.SetParameterLowerBound(x.data(), int(i), put(range.lower));
    problem.SetParameterUpperBound(x.data(), int(i), put(range.upper));
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = max_iterations;
  options.function_tolerance = 1e-5;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary.IsSolutionUsable() ? moved(hypothesis, places, x.data()) : hypothesis;
}

}  // namespace searig::estimator
