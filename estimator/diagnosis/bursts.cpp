#include "estimator/diagnosis/bursts.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/locate.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

constexpr double loud = 2.2;  // times what is expected
constexpr double least_seconds = 2.0;

double median(std::vector<double> x) {
  std::ranges::nth_element(x, x.begin() + std::ptrdiff_t(x.size() / 2));
  return x[x.size() / 2];
}

struct Second {
  double begins_s, loudness, load;  // medians of |residual| and of |torque| or |speed|
};

std::vector<Second> seconds_of(const Bench& bench, const Eigen::VectorXd& residual,
                               const Eigen::VectorXd& load, Eigen::Index from, Eigen::Index to) {
  const Experiment& e = bench.experiment();
  std::vector<Second> out;
  std::vector<double> r, l;
  double second = -1.0;
  const auto close = [&] {
    if (r.size() >= 8) out.push_back({second, median(r), median(l)});
    r.clear(), l.clear();
  };
  for (Eigen::Index i = from; i < to; ++i) {
    if (!e.usable[std::size_t(i)]) continue;
    if (std::floor(e.time(i)) != second) close(), second = std::floor(e.time(i));
    r.push_back(std::abs(residual[i]));
    l.push_back(std::abs(load[i]));
  }
  close();
  return out;
}

/// Loudness that the load explains: a straight line through the quieter two thirds.
std::vector<double> expected(const std::vector<Second>& all) {
  std::vector<double> loudness;
  for (const auto& s : all) loudness.push_back(s.loudness);
  const double usual = median(loudness);
  Eigen::Matrix2d normal = Eigen::Matrix2d::Identity() * 1e-12;
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const auto& s : all) {
    if (s.loudness > 2.0 * usual) continue;
    const Eigen::Vector2d x(1.0, s.load);
    normal += x * x.transpose();
    right += x * s.loudness;
  }
  const Eigen::Vector2d line = normal.ldlt().solve(right);
  std::vector<double> out;
  for (const auto& s : all)
    out.push_back(std::max(0.7 * usual, line[0] + std::max(0.0, line[1]) * s.load));
  return out;
}

std::vector<std::pair<double, double>> loud_intervals(const std::vector<Second>& all) {
  std::vector<std::pair<double, double>> out;
  if (all.size() < 10) return out;
  const auto usual = expected(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].loudness < loud * usual[i]) continue;
    if (!out.empty() && all[i].begins_s - out.back().second < 0.5)
      out.back().second = all[i].begins_s + 1.0;
    else
      out.emplace_back(all[i].begins_s, all[i].begins_s + 1.0);
  }
  std::erase_if(out, [](const auto& i) { return i.second - i.first < least_seconds; });
  return out;
}

}  // namespace

std::optional<Unexplained> loud_while(const Bench& bench, const Hypothesis& hypothesis) {
  const Experiment& e = bench.experiment();
  const Eigen::VectorXd raw = bench.raw_residual(hypothesis, bench.fit(hypothesis));
  Eigen::VectorXd load = Eigen::VectorXd::Zero(e.rows());
  load.head(e.loadcell_rows()) = e.loadcell_nm.head(e.loadcell_rows());
  if (e.has_drive()) load.tail(e.drive_rows()) = e.at_drive(as_array(e.motion.w).matrix());
  const Eigen::Index borders[3] = {0, e.loadcell_rows(), e.rows()};
  for (int block = 0; block < 2; ++block) {
    const auto found =
        loud_intervals(seconds_of(bench, raw, load, borders[block], borders[block + 1]));
    double length = 0.0;
    for (const auto& [from, to] : found) length += to - from;
    if (found.empty() || length > 0.4 * e.motion.t.back()) continue;
    Unexplained out;
    out.located.residuals = residuals_of(block == 0 ? Path::rig : Path::drive);
    for (const auto& [from, to] : found)
      out.located.intervals_s.emplace_back(e.start_s + from, e.start_s + to);
    out.p_value = 0.001;
    out.what = "something shakes for a while";
    return out;
  }
  return std::nullopt;
}

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

}  // namespace

std::optional<Unexplained> blows(const Bench& bench, const Hypothesis& hypothesis) {
  const Experiment& e = bench.experiment();
  const Eigen::VectorXd raw = bench.raw_residual(hypothesis, bench.fit(hypothesis));
  const Eigen::Index borders[3] = {0, e.loadcell_rows(), e.rows()};
  for (int block = 0; block < 2; ++block) {
    std::vector<double> size;
    for (Eigen::Index i = borders[block]; i < borders[block + 1]; ++i)
      if (e.usable[std::size_t(i)]) size.push_back(std::abs(raw[i]));
    if (size.size() < 200) continue;
    const double limit = far * 1.4826 * median(size);
    std::vector<Eigen::Index> marked;
    for (Eigen::Index i = borders[block]; i < borders[block + 1]; ++i)
      if (e.usable[std::size_t(i)] && std::abs(raw[i]) > limit) marked.push_back(i);
    if (double(marked.size()) < least_share * double(size.size())) continue;
    std::pair<double, Region> best{1.0, {}};
    for (const char* channel : places)
      best = std::min(best, crowded(e, marked, channel, block == 1),
                      [](auto& a, auto& b) { return a.first < b.first; });
    Unexplained out;
    out.located.residuals = residuals_of(block == 0 ? Path::rig : Path::drive);
    if (best.second.channel == "time_s")
      out.located.intervals_s = {{e.start_s + best.second.from, e.start_s + best.second.to}};
    else
      out.located.regions = {best.second};
    out.p_value = 0.001;
    out.what = "short blows, far beyond the noise";
    return out;
  }
  return std::nullopt;
}

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
  out.p_value = 0.001;
  out.what = "the load cell's zero wanders";
  return out;
}

}  // namespace searig::estimator
