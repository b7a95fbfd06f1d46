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

constexpr double strip_px = 15.0, axis_px = 34.0, margin_px = 12.0;
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

/// From standard errors to a depth of colour: none for what is chance, full for the largest of the
/// map, in between by the logarithm, so that a hundred before and five after look different.
struct Colours {
  static constexpr double chance = 2.0;
  double full = 20.0;

  explicit Colours(const std::vector<Row>& rows) {
    for (const Row& row : rows)
      for (const Cell& cell : row.cells)
        for (const double score : {cell.before, cell.after})
          if (std::isfinite(score)) full = std::max(full, std::abs(score));
  }
  double depth(double score) const {
    return std::clamp(std::log(std::abs(score) / chance) / std::log(full / chance), 0.0, 1.0);
  }
  double score(double depth) const { return chance * std::pow(full / chance, depth); }
};

void draw_cell(Canvas& canvas, const Colours& colours, double from, double top, double width,
               double score) {
  canvas.rectangle(from, top, std::max(0.5, width - 1.0), strip_px, "grid");
  if (!std::isfinite(score)) return;
  canvas.rectangle(from, top, std::max(0.5, width - 1.0), strip_px,
                   score < 0 ? "blue" : "vermilion", colours.depth(score));
}

void draw_row(Canvas& canvas, const Colours& colours, const Row& row, bool both, double top,
              double width) {
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
    draw_cell(canvas, colours, from, top, to - from, cell.before);
    if (both) draw_cell(canvas, colours, from, top + strip_px + 1, to - from, cell.after);
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

void draw_key(Canvas& canvas, const Colours& colours, double top) {
  constexpr int steps = 10;
  constexpr double step_px = 20.0;
  const auto at = [](int step) { return margin_px + 10.0 + step_px * (step + steps); };
  for (int i = -steps; i <= steps; ++i) {
    canvas.rectangle(at(i), top, step_px, 10, "grid");
    canvas.rectangle(at(i), top, step_px, 10, i < 0 ? "blue" : "vermilion",
                     std::abs(i) / double(steps));
  }
  for (const int step : {-steps, -steps / 2, 0, steps / 2, steps}) {
    const double score = colours.score(std::abs(step) / double(steps));
    const std::string size = figures(score, 2);
    canvas.text(at(step) + step_px / 2, top + 24,
                step == 0 ? "±" + size : (step < 0 ? "−" : "") + size, Anchor::middle, "f");
  }
  canvas.text(at(steps) + step_px + 14, top + 10,
              "mean difference, in standard errors; below 2 it is chance");
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
  const Colours colours(rows);
  canvas.text(margin_px, margin_px + 10, title, Anchor::start, "t");
  for (std::size_t i = 0; i < rows.size(); ++i)
    draw_row(canvas, colours, rows[i], both, rows_top + row_height(both) * double(i), width);
  draw_key(canvas, colours, rows_top + row_height(both) * double(rows.size()));
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
