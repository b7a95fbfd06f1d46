#include "estimator/diagnosis/answer/remainder.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/answer/locate.h"
#include "estimator/diagnosis/search/refine.h"
#include "estimator/order.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

constexpr double far = 5.0;           // robust standard deviations
constexpr double least_share = 0.02;  // of the rows
const char* const places[] = {"deflection_rad", "input_angle_rad",      "output_angle_rad",
                              "time_s",         "input_velocity_rad_s", "output_velocity_rad_s"};

/// The channel whose cells, few of them, hold most of the marked rows.
std::pair<double, Region> crowded(const Experiment& e, const std::vector<Eigen::Index>& marked,
                                  const std::string& channel, bool drive) {
  const auto* values = channel_of(e.motion, channel);
  if (!values) return {1.0, {}};
  const Eigen::VectorXd x = (drive ? e.at_drive : e.at_loadcell)(as_array(*values).matrix());
  std::vector<double> at, all;
  const Eigen::Index begin = drive ? e.loadcell_rows() : 0;
  for (const Eigen::Index i : marked) at.push_back(x[i - begin]);
  for (Eigen::Index i = 0; i < x.size(); ++i)
    if (e.usable[std::size_t(begin + i)]) all.push_back(x[i]);
  std::ranges::sort(at);
  const std::size_t span = std::max<std::size_t>(1, at.size() * 7 / 10);
  std::pair<double, Region> best{1.0, {channel, at.front(), at.back()}};
  for (std::size_t i = 0; i + span < at.size(); ++i) {
    const double from = at[i], to = at[i + span];
    const double share =
        double(std::ranges::count_if(all, [&](double v) { return v >= from && v <= to; })) /
        double(all.size());
    if (share < best.first) best = {share, {channel, from, to}};
  }
  return best;
}

/// The while in which the residual is louder than before and after, on the module's clock.
std::pair<double, double> while_loud(const Experiment& e, const Eigen::VectorXd& raw,
                                     Eigen::Index from, Eigen::Index to) {
  constexpr double cell_s = 0.25;
  std::vector<double> squares(std::size_t(e.motion.t.back() / cell_s) + 1, 0.0), counts = squares;
  for (Eigen::Index i = from; i < to; ++i) {
    if (!e.usable[std::size_t(i)]) continue;
    const auto cell = std::min(std::size_t(e.time(i) / cell_s), squares.size() - 1);
    squares[cell] += raw[i] * raw[i], counts[cell] += 1.0;
  }
  const auto [first, last] = loudest_run(squares, counts);
  return {e.start_s + cell_s * double(first), e.start_s + cell_s * double(last + 1)};
}

}  // namespace

std::optional<Unexplained> blows(const Bench& bench, const Hypothesis& hypothesis) {
  const Experiment& e = bench.experiment();
  const Eigen::VectorXd raw = bench.raw_residual(hypothesis);
  const auto counts = [&](Eigen::Index i) {  // held rows share one error: many of them are one
    return e.usable[std::size_t(i)] && e.weight[std::size_t(i)] > 0.9;
  };
  const Eigen::Index borders[3] = {0, e.loadcell_rows(), e.rows()};
  for (int block = 0; block < 2; ++block) {
    std::vector<double> size;
    for (Eigen::Index i = borders[block]; i < borders[block + 1]; ++i)
      if (counts(i)) size.push_back(std::abs(raw[i]));
    if (size.size() < 200) continue;
    const double limit = far * 1.4826 * median(size);
    std::vector<Eigen::Index> marked;
    for (Eigen::Index i = borders[block]; i < borders[block + 1]; ++i)
      if (counts(i) && std::abs(raw[i]) > limit) marked.push_back(i);
    if (double(marked.size()) < least_share * double(size.size())) continue;
    std::pair<double, Region> best{1.0, {}};
    for (const char* channel : places)
      best = std::min(best, crowded(e, marked, channel, block == 1),
                      [](auto& a, auto& b) { return a.first < b.first; });
    Unexplained out;
    out.located.residuals = residuals_of(block == 0 ? Path::rig : Path::drive);
    if (best.second.channel == "time_s")
      out.located.intervals_s = {while_loud(e, raw, borders[block], borders[block + 1])};
    else
      out.located.regions = {best.second};
    // Chernoff's bound, were one row in a thousand as far out anyway.
    const double m = double(marked.size()), chance = 0.001 * double(size.size());
    out.p_value = std::exp(-(m * std::log(m / chance) - m + chance));
    out.what = "short blows, far beyond the noise";
    return out;
  }
  return std::nullopt;
}

}  // namespace searig::estimator
