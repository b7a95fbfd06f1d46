// A plot with its legend, axes, series and marks on any canvas.
#include <algorithm>
#include <cmath>

#include "app/report/canvas.h"
#include "app/report/decimate.h"
#include "app/report/palette.h"
#include "app/report/plot_frame.h"
#include "app/report/plot_legend.h"

namespace searig::app {
namespace {

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

/// There along the lower edge, back along the upper one; broken where a line would be.
void draw_band(Canvas& canvas, const Series& series, const Frame& frame) {
  const std::size_t size = std::min({series.x.size(), series.y.size(), series.y_high.size()});
  const std::size_t stride = std::max<std::size_t>(1, size / static_cast<std::size_t>(frame.width));
  Points lower, upper;
  const auto close = [&] {
    lower.insert(lower.end(), upper.rbegin(), upper.rend());
    if (!lower.empty()) canvas.polygon(lower, shades(series.hue).name, 0.22);
    lower.clear(), upper.clear();
  };
  for (std::size_t i = 0; i < size; i += stride) {
    if (!std::isfinite(series.y[i]) || !std::isfinite(series.y_high[i])) {
      close();
      continue;
    }
    const double x = frame.to_x(series.x[i]);
    lower.emplace_back(x, frame.to_y(series.y[i]));
    upper.emplace_back(x, frame.to_y(series.y_high[i]));
  }
  close();
}

void draw_series(Canvas& canvas, const Series& series, const Frame& frame) {
  if (series.style == Style::band) return draw_band(canvas, series, frame);
  const std::string paint = shades(series.hue).name;
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
    canvas.line(frame.left, y, frame.left + frame.width, y, shades(level.hue).name, Stroke::dashed);
  }
  for (const auto& mark : plot.marks) {
    const double x = frame.to_x(mark.x);
    const bool at_right = x > frame.left + 0.7 * frame.width;
    canvas.line(x, frame.top, x, frame.top + frame.height, shades(mark.hue).name, Stroke::dotted);
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
  top += draw_legend(canvas, plot, margin_px, top, size.width - margin_px) + 4.0;

  const Frame frame = lay_out(plot, size, top);
  const auto clip = [&] { canvas.begin_clip(frame.left, frame.top, frame.width, frame.height); };
  clip();
  for (const auto& interval : plot.shaded) {
    const double from = frame.to_x(interval.from), to = frame.to_x(interval.to);
    canvas.rectangle(std::min(from, to), frame.top, std::max(1.0, std::abs(to - from)),
                     frame.height, shades(interval.hue).name, 0.14);
  }
  canvas.end_clip();
  draw_axes(canvas, frame, plot);
  clip();
  for (const auto& series : plot.series) draw_series(canvas, series, frame);
  draw_marks(canvas, plot, frame);
  canvas.end_clip();
}

}  // namespace searig::app
