#include "app/report/diagnosis_map.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/report/axis.h"
#include "app/report/quantity.h"
#include "app/report/svg_canvas.h"

namespace searig::app {
namespace {

using estimator::Cell;

constexpr double strip_px = 15.0, axis_px = 34.0, margin_px = 12.0, full_scale = 6.0;
constexpr double words_px = 250.0;

/// Cells of one channel that lie side by side.
struct Row {
  std::string name, channel;
  std::vector<Cell> cells;
};

/// A channel that is looked at in both directions has two cells for each part of its range: the
/// first while it rises, the second while it falls.
std::vector<Row> rows_of(const std::vector<Cell>& cells, const std::string& residual) {
  std::map<std::string, std::vector<Cell>> by_channel;
  std::vector<std::string> order;
  for (const Cell& cell : cells) {
    if (cell.residual != residual) continue;
    auto& group = by_channel[cell.region.channel];
    if (group.empty()) order.push_back(cell.region.channel);
    // A second map over the same channel starts over; the first says enough.
    if (!group.empty() && cell.region.from < group.back().region.from) continue;
    group.push_back(cell);
  }
  std::vector<Row> rows;
  for (const auto& channel : order) {
    const auto& group = by_channel[channel];
    Row rising{quantity_of(channel).name, channel, {}}, falling = rising;
    for (const Cell& cell : group) {
      const bool second =
          !rising.cells.empty() && rising.cells.back().region.from == cell.region.from;
      (second ? falling : rising).cells.push_back(cell);
    }
    if (!falling.cells.empty()) {
      rising.name += ", forward";
      falling.name += ", backward";
    }
    rows.push_back(rising);
    if (!falling.cells.empty()) rows.push_back(falling);
  }
  return rows;
}

void draw_cell(Canvas& canvas, double from, double top, double width, double score) {
  canvas.rectangle(from, top, std::max(0.5, width - 1.0), strip_px, "grid");
  if (!std::isfinite(score)) return;
  const double depth = std::clamp(std::abs(score) / full_scale, 0.0, 1.0);
  canvas.rectangle(from, top, std::max(0.5, width - 1.0), strip_px,
                   score < 0 ? "blue" : "vermilion", depth);
}

void draw_row(Canvas& canvas, const Row& row, bool both, double top, double width) {
  const double left = words_px + 62.0, right = width - margin_px - 16.0;
  const Axis axis = make_axis({row.cells.front().region.from, row.cells.back().region.to}, 7);
  const auto to_x = [&](double value) {
    return left + (right - left) * (value - axis.range.low) / (axis.range.high - axis.range.low);
  };
  const double bottom = top + strip_px * (both ? 2.0 : 1.0);
  canvas.text(margin_px, (top + bottom) / 2 + 4, row.name);
  if (both) {
    canvas.text(left - 8, top + strip_px - 3, "before", Anchor::end, "f");
    canvas.text(left - 8, bottom - 3, "after", Anchor::end, "f");
  }
  for (const Cell& cell : row.cells) {
    const double from = to_x(cell.region.from), to = to_x(cell.region.to);
    draw_cell(canvas, from, top, to - from, cell.before);
    if (both) draw_cell(canvas, from, top + strip_px + 1, to - from, cell.after);
  }
  const std::string unit = quantity_of(row.channel).unit;
  for (std::size_t i = 0; i < axis.ticks.size(); ++i) {
    const double x = to_x(axis.ticks[i]);
    canvas.line(x, bottom + 1, x, bottom + 5, "faint");
    const bool last = i + 1 == axis.ticks.size();
    canvas.text(x, bottom + 17,
                axis.label(axis.ticks[i]) + (last && !unit.empty() ? " " + unit : ""),
                Anchor::middle, "f");
  }
}

void draw_key(Canvas& canvas, double top) {
  constexpr int steps = 10;
  constexpr double step_px = 14.0;
  for (int i = -steps; i <= steps; ++i) {
    const double x = margin_px + step_px * (i + steps);
    canvas.rectangle(x, top, step_px, 10, "grid");
    canvas.rectangle(x, top, step_px, 10, i < 0 ? "blue" : "vermilion",
                     std::abs(i) / double(steps));
  }
  const double right = margin_px + step_px * (2 * steps + 1);
  canvas.text(margin_px, top + 24, number(-full_scale, 0) + " or less", Anchor::start, "f");
  canvas.text((margin_px + right) / 2, top + 24, "0", Anchor::middle, "f");
  canvas.text(right, top + 24, number(full_scale, 0) + " or more", Anchor::end, "f");
  canvas.text(right + 14, top + 10, "mean difference, in standard errors");
}

constexpr double rows_top = margin_px + 30.0;

double row_height(bool both) {
  return strip_px * (both ? 2.0 : 1.0) + axis_px;
}

}  // namespace

int map_height(const std::vector<Cell>& cells, const std::string& residual, bool both) {
  const auto rows = rows_of(cells, residual);
  if (rows.empty()) return 0;
  return static_cast<int>(rows_top + row_height(both) * double(rows.size()) + 34.0);
}

void draw_mismatch_map(Canvas& canvas, const std::vector<Cell>& cells, const std::string& residual,
                       const std::string& title, bool both, int width) {
  const auto rows = rows_of(cells, residual);
  if (rows.empty()) return;
  canvas.text(margin_px, margin_px + 10, title, Anchor::start, "t");
  for (std::size_t i = 0; i < rows.size(); ++i)
    draw_row(canvas, rows[i], both, rows_top + row_height(both) * double(i), width);
  draw_key(canvas, rows_top + row_height(both) * double(rows.size()));
}

std::string mismatch_map(const std::vector<Cell>& cells, const std::string& residual,
                         const std::string& title, bool both, int width) {
  const int height = map_height(cells, residual, both);
  if (height == 0) return "";
  SvgCanvas canvas({width, height}, title);
  draw_mismatch_map(canvas, cells, residual, title, both, width);
  return std::move(canvas).finish();
}

}  // namespace searig::app
