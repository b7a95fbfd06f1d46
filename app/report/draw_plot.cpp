// A plot with its legend, axes, series and marks on any canvas.
#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/canvas.h"
#include "app/report/decimate.h"

namespace searig::app {
namespace {

constexpr double margin_px = 12.0;
constexpr double row_px = 18.0;  // of the legend

/// The rectangle the data are drawn in, and both axes.
struct Frame {
  double left, top, width, height;
  Axis x, y;

  double to_x(double value) const {
    return left + width * (value - x.range.low) / (x.range.high - x.range.low);
  }
  double to_y(double value) const {
    return top + height * (y.range.high - value) / (y.range.high - y.range.low);
  }
};

std::string name_of(Hue hue) {
  return shades(hue).name;
}

struct LegendEntry {
  std::string name;
  Hue hue;
  enum class Sign { stroke, dashes, area, dot } sign;
};

std::vector<LegendEntry> legend_of(const Plot& plot) {
  std::vector<LegendEntry> entries;
  for (const auto& series : plot.series) {
    if (!series.name.empty()) {
      const auto sign = series.style == Style::band   ? LegendEntry::Sign::area
                        : series.style == Style::dots ? LegendEntry::Sign::dot
                                                      : LegendEntry::Sign::stroke;
      entries.push_back({series.name, series.hue, sign});
    }
  }
  for (const auto& level : plot.levels) {
    if (!level.name.empty()) entries.push_back({level.name, level.hue, LegendEntry::Sign::dashes});
  }
  if (!plot.shaded.empty() && !plot.shaded_name.empty()) {
    entries.push_back({plot.shaded_name, plot.shaded.front().hue, LegendEntry::Sign::area});
  }
  return entries;
}

void draw_sign(Canvas& canvas, const LegendEntry& entry, double x, double y) {
  using Sign = LegendEntry::Sign;
  const std::string paint = name_of(entry.hue);
  if (entry.sign == Sign::area) return canvas.rectangle(x, y + 2, 20, 10, paint, 0.3);
  if (entry.sign == Sign::dot) return canvas.dots({{x + 10, y + 7}}, paint, 5.0);
  canvas.line(x, y + 7, x + 20, y + 7, paint,
              entry.sign == Sign::dashes ? Stroke::dashed : Stroke::thick);
}

/// Draws the legend above the data, where it can cover none; returns the height it took.
double draw_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, double left, double top,
                   double right) {
  if (entries.empty()) return 0.0;
  double x = left, y = top;
  for (const auto& entry : entries) {
    const double width = 26.0 + text_width(entry.name) + 14.0;
    if (x > left && x + width > right) {
      x = left;
      y += row_px;
    }
    draw_sign(canvas, entry, x, y);
    canvas.text(x + 26, y + 11, entry.name);
    x += width;
  }
  return y + row_px - top;
}

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

std::string with_exponent(const std::string& label, const Axis& axis) {
  return axis.exponent == 0 ? label : label + " × 1e" + std::to_string(axis.exponent);
}

void draw_axes(Canvas& canvas, const Frame& frame, const Plot& plot) {
  const double bottom = frame.top + frame.height, right = frame.left + frame.width;
  for (const double tick : frame.y.ticks) {
    const double y = frame.to_y(tick);
    canvas.line(frame.left, y, right, y, "grid");
    canvas.text(frame.left - 7, y + 4, frame.y.label(tick), Anchor::end, "f");
  }
  for (const double tick : frame.x.ticks) {
    const double x = frame.to_x(tick);
    canvas.line(x, frame.top, x, bottom, "grid");
    canvas.text(x, bottom + 16, frame.x.label(tick), Anchor::middle, "f");
  }
  canvas.line(frame.left, bottom, right, bottom, "faint");
  canvas.line(frame.left, frame.top, frame.left, bottom, "faint");
  if (!plot.x_label.empty()) {
    canvas.text(frame.left + frame.width / 2, bottom + 36, with_exponent(plot.x_label, frame.x),
                Anchor::middle);
  }
  if (!plot.y_label.empty()) {
    canvas.text_upwards(margin_px + 6, frame.top + frame.height / 2,
                        with_exponent(plot.y_label, frame.y));
  }
}

/// Which points to draw. A line whose x does not rise (torque over deflection) is drawn whole.
std::vector<std::size_t> points_of(const Series& series, const Frame& frame) {
  const std::size_t size = std::min(series.x.size(), series.y.size());
  if (series.style == Style::line && std::is_sorted(series.x.begin(), series.x.begin() + size)) {
    return decimate(series.x, series.y, frame.x.range.low, frame.x.range.high,
                    static_cast<std::size_t>(frame.width));
  }
  std::vector<std::size_t> all(size);
  for (std::size_t i = 0; i < size; ++i) all[i] = i;
  return all;
}

/// The band's outline: there along the lower edge, back along the upper one.
void draw_band(Canvas& canvas, const Series& series, const Frame& frame) {
  Points outline;
  const std::size_t size = std::min({series.x.size(), series.y.size(), series.y_high.size()});
  const std::size_t stride = std::max<std::size_t>(1, size / static_cast<std::size_t>(frame.width));
  const auto add = [&](std::size_t i, double y) {
    if (std::isfinite(y)) outline.emplace_back(frame.to_x(series.x[i]), frame.to_y(y));
  };
  for (std::size_t i = 0; i < size; i += stride) add(i, series.y[i]);
  for (std::size_t n = (size + stride - 1) / stride; n-- > 0;) {
    add(n * stride, series.y_high[n * stride]);
  }
  canvas.polygon(outline, name_of(series.hue), 0.22);
}

void draw_series(Canvas& canvas, const Series& series, const Frame& frame) {
  if (series.style == Style::band) return draw_band(canvas, series, frame);
  const std::string paint = name_of(series.hue);
  Points run;
  for (const std::size_t i : points_of(series, frame)) {
    if (!std::isfinite(series.x[i]) || !std::isfinite(series.y[i])) {
      if (series.style != Style::dots) canvas.polyline(run, paint), run.clear();
      continue;
    }
    const std::pair point(frame.to_x(series.x[i]), frame.to_y(series.y[i]));
    if (series.style == Style::steps && !run.empty()) {
      run.emplace_back(point.first, run.back().second);
    }
    run.push_back(point);
  }
  if (series.style == Style::dots) {
    constexpr std::size_t few = 100;  // so few can be large
    return canvas.dots(run, paint, run.size() <= few ? 5.0 : 3.0);
  }
  if (!run.empty()) canvas.polyline(run, paint);
}

void draw_marks(Canvas& canvas, const Plot& plot, const Frame& frame) {
  for (const auto& level : plot.levels) {
    const double y = frame.to_y(level.y);
    canvas.line(frame.left, y, frame.left + frame.width, y, name_of(level.hue), Stroke::dashed);
  }
  for (const auto& mark : plot.marks) {
    const double x = frame.to_x(mark.x);
    const bool at_right = x > frame.left + 0.7 * frame.width;
    canvas.line(x, frame.top, x, frame.top + frame.height, name_of(mark.hue), Stroke::dotted);
    canvas.text(at_right ? x - 5 : x + 5, frame.top + 13, mark.text,
                at_right ? Anchor::end : Anchor::start);
  }
}

}  // namespace

double text_width(std::string_view words, double font_px) {
  std::size_t characters = 0;  // UTF-8: continuation bytes are no characters of their own
  for (const char c : words) characters += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  return 0.6 * font_px * static_cast<double>(characters);
}

void draw(Canvas& canvas, const Plot& plot, Size size) {
  double top = margin_px;
  if (!plot.title.empty()) {
    canvas.text(margin_px, top + 10, plot.title, Anchor::start, "t");
    top += 22.0;
  }
  top += draw_legend(canvas, legend_of(plot), margin_px, top, size.width - margin_px) + 4.0;

  const Frame frame = lay_out(plot, size, top);
  const auto clip = [&] { canvas.begin_clip(frame.left, frame.top, frame.width, frame.height); };
  clip();
  for (const auto& interval : plot.shaded) {
    const double from = frame.to_x(interval.from), to = frame.to_x(interval.to);
    canvas.rectangle(std::min(from, to), frame.top, std::max(1.0, std::abs(to - from)),
                     frame.height, name_of(interval.hue), 0.14);
  }
  canvas.end_clip();
  draw_axes(canvas, frame, plot);
  clip();
  for (const auto& series : plot.series) draw_series(canvas, series, frame);
  draw_marks(canvas, plot, frame);
  canvas.end_clip();
}

}  // namespace searig::app
