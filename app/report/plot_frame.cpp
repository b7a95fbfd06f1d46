#include "app/report/plot_frame.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "app/report/canvas.h"

namespace searig::app {
namespace {

/// The values of a column that are in view.
std::vector<double> in_view(const std::vector<double>& x, const std::vector<double>& y,
                            const std::optional<Range>& view) {
  if (!view) return y;
  std::vector<double> out;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (x[i] >= view->low && x[i] <= view->high) out.push_back(y[i]);
  }
  return out;
}

Range y_range_of(const Plot& plot) {
  if (plot.y_range) return *plot.y_range;
  std::vector<double> seen;
  const auto add = [&seen](const std::vector<double>& values) {
    seen.insert(seen.end(), values.begin(), values.end());
  };
  for (const auto& series : plot.series) {
    add(in_view(series.x, series.y, plot.x_range));
    if (series.style == Style::band) add(in_view(series.x, series.y_high, plot.x_range));
  }
  for (const auto& level : plot.levels) seen.push_back(level.y);
  return span_of({&seen}, 0.05);
}

Range x_range_of(const Plot& plot) {
  if (plot.x_range) return *plot.x_range;
  std::vector<const std::vector<double>*> columns;
  for (const auto& series : plot.series) columns.push_back(&series.x);
  return span_of(columns, 0.0);
}

}  // namespace

Frame lay_out(const Plot& plot, Size size, double top) {
  Frame frame;
  const double bottom = 22.0 + (plot.x_label.empty() ? 0.0 : 20.0);
  frame.top = top;
  frame.height = std::max(40.0, size.height - top - bottom - 4.0);
  frame.y = make_axis(y_range_of(plot), std::max(2, static_cast<int>(frame.height / 45.0)));
  double widest = 0.0;
  for (const double tick : frame.y.ticks) {
    widest = std::max(widest, text_width(frame.y.label(tick)));
  }
  frame.left = margin_px + widest + 8.0 + (plot.y_label.empty() ? 0.0 : 20.0);
  frame.width = std::max(60.0, size.width - frame.left - margin_px - 8.0);
  frame.x = make_axis(x_range_of(plot),
                      plot.x_ticks.value_or(std::max(2, static_cast<int>(frame.width / 90.0))));
  return frame;
}

}  // namespace searig::app
