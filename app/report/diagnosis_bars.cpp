#include "app/report/diagnosis_bars.h"

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/svg_canvas.h"

namespace searig::app {
namespace {

constexpr double margin_px = 12.0, row_px = 26.0, top_px = 42.0;

double widest(const std::vector<std::string>& names) {
  double out = 60.0;
  for (const auto& name : names) out = std::max(out, text_width(name));
  return out;
}

double percent_off(double value, const Known& p) {
  return 100.0 * (value - p.value) / std::abs(p.value);
}

/// Wide enough for every interval; a given number far outside is drawn at the border.
double half_range(const std::vector<Known>& parameters) {
  double intervals = 0.5, all = 0.5;
  for (const Known& p : parameters) {
    const double half = std::max(-percent_off(p.lower, p), percent_off(p.upper, p));
    intervals = std::max(intervals, half);
    if (p.given) all = std::max(all, std::abs(percent_off(*p.given, p)));
  }
  return 1.1 * std::max(intervals, std::min(all, 25.0));
}

void draw_interval(Canvas& canvas, const Known& p, double y, double left, double right,
                   double half) {
  const auto to_x = [&](double percent) {
    return left + (right - left) * (std::clamp(percent, -half, half) + half) / (2 * half);
  };
  const double from = to_x(percent_off(p.lower, p)), to = to_x(percent_off(p.upper, p));
  canvas.text(left - 10, y + 4, p.name, Anchor::end);
  canvas.line(left, y, right, y, "grid");
  canvas.rectangle(from, y - 5, std::max(1.5, to - from), 10, "blue", 0.35);
  canvas.dots({{to_x(0), y}, {to_x(0), y}}, "blue");
  canvas.line(to_x(0), y - 5, to_x(0), y + 5, "blue", Stroke::thick);
  if (!p.given) return;
  const double off = percent_off(*p.given, p), x = to_x(off);
  canvas.line(x - 4, y - 4, x + 4, y + 4, "vermilion", Stroke::thick);
  canvas.line(x - 4, y + 4, x + 4, y - 4, "vermilion", Stroke::thick);
  if (std::abs(off) > half) {
    const bool high = off > 0;
    canvas.text(high ? x - 9 : x + 9, y + 4, number(off, 0) + " %",
                high ? Anchor::end : Anchor::start, "f");
  }
}

void draw_legend(Canvas& canvas, double y, bool given) {
  canvas.rectangle(margin_px, y - 9, 20, 10, "blue", 0.35);
  canvas.line(margin_px + 10, y - 9, margin_px + 10, y + 1, "blue", Stroke::thick);
  canvas.text(margin_px + 26, y, "measured, with its 95 % interval");
  if (!given) return;
  const double x = margin_px + 26 + text_width("measured, with its 95 % interval") + 24;
  canvas.line(x - 4, y - 8, x + 4, y, "vermilion", Stroke::thick);
  canvas.line(x - 4, y, x + 4, y - 8, "vermilion", Stroke::thick);
  canvas.text(x + 12, y, "as the model had it");
}

}  // namespace

std::string probability_bars(const std::string& title, const std::vector<Bar>& bars, int width) {
  std::vector<std::string> names;
  for (const Bar& bar : bars) names.push_back(bar.name);
  const double left = margin_px + widest(names) + 12.0, right = width - margin_px - 60.0;
  SvgCanvas canvas({width, static_cast<int>(top_px + row_px * double(bars.size()))}, title);
  canvas.text(margin_px, margin_px + 10, title, Anchor::start, "t");
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const double y = top_px + row_px * double(i);
    const double share = std::clamp(bars[i].share, 0.0, 1.0);
    canvas.text(left - 10, y + 12, bars[i].name, Anchor::end);
    canvas.rectangle(left, y, right - left, 16, "grid");
    canvas.rectangle(left, y, std::max(1.0, share * (right - left)), 16,
                     bars[i].chosen ? "blue" : "faint");
    canvas.text(right + 8, y + 12,
                number(100.0 * share, share > 0.99 || share < 0.01 ? 1 : 0) + " %");
  }
  return std::move(canvas).finish();
}

std::string interval_plot(const std::string& title, const std::vector<Known>& parameters,
                          int width) {
  std::vector<Known> shown;
  std::vector<std::string> names;
  bool given = false;
  for (const Known& p : parameters) {
    if (!(p.lower > 0 || p.upper < 0) || !std::isfinite(p.upper - p.lower)) continue;
    shown.push_back(p);
    names.push_back(p.name);
    given = given || p.given;
  }
  if (shown.empty()) return "";
  const double left = margin_px + widest(names) + 14.0, right = width - margin_px - 24.0;
  const double top = top_px + 18.0, bottom = top + row_px * double(shown.size());
  SvgCanvas canvas({width, static_cast<int>(bottom + 48.0)}, title);
  canvas.text(margin_px, margin_px + 10, title, Anchor::start, "t");
  draw_legend(canvas, margin_px + 32, given);
  const double half = half_range(shown);
  const Axis axis = make_axis({-half, half}, 8);
  for (const double tick : axis.ticks) {
    const double x = left + (right - left) * (tick + half) / (2 * half);
    canvas.line(x, top - 4, x, bottom, "grid");
    canvas.text(x, bottom + 16, axis.label(tick), Anchor::middle, "f");
  }
  for (std::size_t i = 0; i < shown.size(); ++i) {
    draw_interval(canvas, shown[i], top + row_px * (double(i) + 0.5), left, right, half);
  }
  canvas.text((left + right) / 2, bottom + 36, "difference from the measured value (%)",
              Anchor::middle);
  return std::move(canvas).finish();
}

}  // namespace searig::app
