#include "estimator/diagnosis/search/dense_map.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

/// Cell borders that hold equal numbers of samples; fewer cells where values repeat.
std::vector<double> quantiles(std::vector<double> x, int cells) {
  std::ranges::sort(x);
  std::vector<double> out;
  for (int i = 0; i <= cells; ++i) {
    const double v = x[std::size_t(double(i) / cells * double(x.size() - 1))];
    if (out.empty() || v > out.back()) out.push_back(v);
  }
  if (!out.empty()) out.back() = std::nextafter(out.back(), INFINITY);
  return out;
}

struct Axis {
  Path path;
  std::string channel;
  const std::vector<double>* values;
  int cells;
  const std::vector<double>* sign = nullptr;  // split by its sign where given
};

std::vector<double> time_since_reversal(const Motion& m) {
  std::vector<double> out(m.size(), 0.0);
  double since = 0.0;
  for (std::size_t i = 1; i < m.size(); ++i) {
    if (m.theta_rate[i] * m.theta_rate[i - 1] <= 0) since = m.t[i];
    out[i] = m.t[i] - since;
  }
  return out;
}

void add_cells(const Axis& axis, double min_share, std::vector<Atom>& out) {
  const auto& x = *axis.values;
  if (x.empty()) return;
  const auto n = Eigen::Index(x.size());
  const auto borders = quantiles(x, axis.cells);
  for (std::size_t c = 0; c + 1 < borders.size(); ++c)
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && !axis.sign) break;
      Eigen::VectorXd cell = Eigen::VectorXd::Zero(n);
      for (Eigen::Index i = 0; i < n; ++i) {
        const auto k = std::size_t(i);
        const bool inside = x[k] >= borders[c] && x[k] < borders[c + 1];
        if (inside && (!axis.sign || (*axis.sign)[k] * side > 0)) cell[i] = 1.0;
      }
      if (cell.sum() >= min_share * double(n))
        out.push_back(
            {"", axis.path, axis.channel, borders[c], borders[c + 1], false, std::move(cell)});
    }
}

}  // namespace

std::vector<Atom> dense_map(const Motion& m, double min_share) {
  std::vector<Atom> out;
  std::vector<Axis> axes;
  std::vector<double> since;
  if (m.has_spring()) {
    since = time_since_reversal(m);
    axes.push_back({Path::spring, "deflection_rad", &m.theta, 16, &m.theta_rate});
    axes.push_back({Path::spring, "deflection_rate_rad_s", &m.theta_rate, 12});
    axes.push_back({Path::spring, "time_since_reversal_s", &since, 5, &m.theta_rate});
    axes.push_back({Path::rig, "deflection_rad", &m.theta, 12});
    axes.push_back({Path::rig, "deflection_rate_rad_s", &m.theta_rate, 6});
  }
  axes.push_back({Path::rig, "output_angle_rad", &m.q_o, 12});
  axes.push_back({Path::rig, "output_acceleration_rad_s2", &m.a_o, 6});
  axes.push_back({Path::rig, "time_s", &m.t, 14});
  if (m.has_drive()) {
    axes.push_back({Path::drive, "input_velocity_rad_s", &m.w, 14});
    axes.push_back({Path::drive, "input_angle_rad", &m.q_i, 12});
    axes.push_back({Path::drive, "current_a", &m.current, 8, &m.w});
    axes.push_back({Path::drive, "input_acceleration_rad_s2", &m.a, 6});
    axes.push_back({Path::drive, "time_s", &m.t, 12});
  }
  for (const auto& axis : axes) add_cells(axis, min_share, out);
  return out;
}

}  // namespace searig::estimator
