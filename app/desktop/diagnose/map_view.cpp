#include "app/desktop/diagnose/map_view.h"

#include <utility>

#include "app/desktop/painter_canvas.h"
#include "app/report/diagnosis_map.h"
#include "app/report/diagnosis_plots.h"

namespace searig::app::desktop {
namespace {

struct Map {
  const char* residual;
  const char* title;
};
constexpr Map spring_map{"loadcell-spring", "Load cell less spring, part by part"};
constexpr Map drive_map{"loadcell-drive", "Load cell less motor current, part by part"};

/// The one that shows the finding comes first.
std::vector<Map> maps_of(const Examined& examined) {
  std::vector<Map> maps{spring_map, drive_map};
  if (main_path(examined) == Against::drive) std::swap(maps[0], maps[1]);
  if (!examined.diagnosis.spring)
    std::erase_if(maps, [](const Map& map) { return map.residual == spring_map.residual; });
  return maps;
}

}  // namespace

MapView::MapView(QWidget* parent) : QWidget(parent) {
  setMinimumWidth(560);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
}

bool MapView::both() const {
  return !examined_->diagnosis.findings.empty() || examined_->diagnosis.unexplained.has_value();
}

void MapView::show_map(std::shared_ptr<const Examined> examined) {
  examined_ = std::move(examined);
  int height = 0;
  if (examined_)
    for (const Map& map : maps_of(*examined_))
      height += map_height(examined_->diagnosis.map, map.residual, both());
  setMinimumHeight(height);
  update();
}

void MapView::set_theme(const Theme& theme) {
  theme_ = theme;
  update();
}

void MapView::paintEvent(QPaintEvent*) {
  if (!examined_) return;
  QPainter painter(this);
  PainterCanvas canvas(painter, theme_);
  const auto& cells = examined_->diagnosis.map;
  for (const Map& map : maps_of(*examined_)) {
    draw_mismatch_map(canvas, cells, map.residual, map.title, both(), width());
    painter.translate(0.0, map_height(cells, map.residual, both()));
  }
}

}  // namespace searig::app::desktop
