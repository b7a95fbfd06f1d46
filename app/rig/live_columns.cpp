#include "app/rig/live_columns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace searig::app {
namespace {

using Column = std::vector<double>;

/// Calls f with each group: its times, and the columns in step with them.
template <typename Columns, typename F>
void for_groups(Columns& c, F f) {
  f(c.t_s, std::array{&c.torque_nm, &c.low_nm, &c.high_nm, &c.clock_low_nm, &c.clock_high_nm,
                      &c.weight, &c.k_nm_per_rad, &c.k_low_nm_per_rad, &c.k_high_nm_per_rad,
                      &c.deflection_rad, &c.output_angle_rad});
  f(c.loadcell_t_s, std::array{&c.loadcell_nm});
  for (auto& residuals : c.residuals) f(residuals.t_s, std::array{&residuals.nm});
}

void join(Column& column, const Column& later) {
  column.insert(column.end(), later.begin(), later.end());
}

}  // namespace

void LiveColumns::append(const LiveColumns& later) {
  std::vector<Column*> mine;
  std::vector<const Column*> its;
  for_groups(*this, [&](Column& t, const auto& columns) {
    mine.push_back(&t);
    mine.insert(mine.end(), columns.begin(), columns.end());
  });
  for_groups(later, [&](const Column& t, const auto& columns) {
    its.push_back(&t);
    its.insert(its.end(), columns.begin(), columns.end());
  });
  for (std::size_t i = 0; i < mine.size(); ++i) join(*mine[i], *its[i]);
}

bool LiveColumns::forget_before(double t) {
  bool any = false;
  for_groups(*this, [&](Column& times, const auto& columns) {
    const auto gone = std::lower_bound(times.begin(), times.end(), t) - times.begin();
    if (gone == 0) return;
    any = true;
    times.erase(times.begin(), times.begin() + gone);
    for (Column* column : columns) column->erase(column->begin(), column->begin() + gone);
  });
  return any;
}

double LiveColumns::error_percent(double from_s) const {
  // Readings outnumber residuals by the last few, which have no estimate yet.
  double error = 0.0, size = 0.0;
  std::size_t compared = 0, readings = 0;
  const auto sum = [from_s](const Column& t, const Column& values, double& total,
                            std::size_t& count) {
    for (std::size_t i = t.size(); i > 0 && t[i - 1] >= from_s; --i, ++count)
      total += std::abs(values[i - 1]);
  };
  for (const auto& residual : residuals) sum(residual.t_s, residual.nm, error, compared);
  sum(loadcell_t_s, loadcell_nm, size, readings);
  if (compared == 0 || !(size > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return 100.0 * (error / double(compared)) / (size / double(readings));
}

}  // namespace searig::app
