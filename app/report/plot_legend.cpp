#include "app/report/plot_legend.h"

#include <string>
#include <vector>

#include "app/report/palette.h"

namespace searig::app {
namespace {

constexpr double row_px = 18.0;

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
  const std::string paint = shades(entry.hue).name;
  if (entry.sign == Sign::area) return canvas.rectangle(x, y + 2, 20, 10, paint, 0.3);
  if (entry.sign == Sign::dot) return canvas.dots({{x + 10, y + 7}}, paint, 5.0);
  canvas.line(x, y + 7, x + 20, y + 7, paint,
              entry.sign == Sign::dashes ? Stroke::dashed : Stroke::thick);
}

}  // namespace

double draw_legend(Canvas& canvas, const Plot& plot, double left, double top, double right) {
  const std::vector<LegendEntry> entries = legend_of(plot);
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

}  // namespace searig::app
