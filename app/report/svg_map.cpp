// The one-dimensional maps: channel cells coloured by a signed number.
#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/svg.h"
#include "app/report/svg_canvas.h"

namespace searig::app {
namespace {

constexpr double cell_px = 24.0, row_px = 58.0, margin_px = 12.0;

struct Paint {
  const char* hue;
  double opacity;
};

Paint paint_of(double value, double full_scale) {
  const double depth = std::clamp(std::abs(value) / full_scale, 0.0, 1.0);
  return {value < 0.0 ? "blue" : "vermilion", depth};
}

void draw_row(Canvas& canvas, const CellMap::Row& row, double full_scale, double left, double top,
              double width) {
  if (row.edges.size() < 2) return;
  const Axis axis =
      make_axis({row.edges.front(), row.edges.back()}, std::max(2, static_cast<int>(width / 90.0)));
  const auto to_x = [&](double value) {
    return left + width * (value - axis.range.low) / (axis.range.high - axis.range.low);
  };
  canvas.text(left - 10, top + cell_px / 2 + 4, row.channel, Anchor::end);
  for (std::size_t i = 0; i + 1 < row.edges.size() && i < row.values.size(); ++i) {
    const double from = to_x(row.edges[i]), size = to_x(row.edges[i + 1]) - from;
    if (!std::isfinite(row.values[i])) {
      canvas.line(from, top + cell_px / 2, from + size, top + cell_px / 2, "grid");
      continue;
    }
    const auto [hue, opacity] = paint_of(row.values[i], full_scale);
    canvas.rectangle(from, top, std::max(0.5, size - 1.0), cell_px, "grid");
    canvas.rectangle(from, top, std::max(0.5, size - 1.0), cell_px, hue, opacity);
  }
  for (const double tick : axis.ticks) {
    canvas.line(to_x(tick), top + cell_px, to_x(tick), top + cell_px + 4, "faint");
    canvas.text(to_x(tick), top + cell_px + 17, axis.label(tick), Anchor::middle, "f");
  }
}

/// The scale of colours, from the lowest to the highest that is told apart.
void draw_key(Canvas& canvas, const CellMap& map, double left, double top) {
  constexpr int steps = 10;
  constexpr double step_px = 16.0;
  for (int i = -steps; i <= steps; ++i) {
    const auto [hue, opacity] =
        paint_of(map.full_scale * i / static_cast<double>(steps), map.full_scale);
    const double x = left + step_px * (i + steps);
    canvas.rectangle(x, top, step_px, 10, "grid");
    canvas.rectangle(x, top, step_px, 10, hue, opacity);
  }
  const double right = left + step_px * (2 * steps + 1);
  canvas.text(left, top + 24, number(-map.full_scale, 0) + " or less", Anchor::start, "f");
  canvas.text((left + right) / 2, top + 24, "0", Anchor::middle, "f");
  canvas.text(right, top + 24, number(map.full_scale, 0) + " or more", Anchor::end, "f");
  canvas.text(right + 12, top + 10, map.value_label);
}

}  // namespace

std::string to_svg(const CellMap& map, int width) {
  double left = 80.0;
  for (const auto& row : map.rows) left = std::max(left, text_width(row.channel) + 24.0);
  const double rows_top = margin_px + 30.0;
  const double key_top = rows_top + row_px * static_cast<double>(map.rows.size());
  SvgCanvas canvas({width, static_cast<int>(key_top + 36.0)}, map.title);
  canvas.text(margin_px, margin_px + 10, map.title, Anchor::start, "t");
  for (std::size_t i = 0; i < map.rows.size(); ++i) {
    draw_row(canvas, map.rows[i], map.full_scale, left, rows_top + row_px * static_cast<double>(i),
             width - left - margin_px - 16.0);
  }
  draw_key(canvas, map, left, key_top);
  return std::move(canvas).finish();
}

}  // namespace searig::app
