#include "app/desktop/layout_description.h"

#include <QAbstractButton>
#include <QLabel>
#include <string>

#include "app/desktop/plot/time_plot.h"

namespace searig::app::desktop {
namespace {

nlohmann::json place_of(const TimePlot& plot, const QWidget& window) {
  const QPoint corner = plot.canvas().mapTo(&window, QPoint(0, 0));
  const Range x = plot.x_range(), y = plot.y_range();
  return {{"left", corner.x()},
          {"top", corner.y()},
          {"width", plot.canvas().width()},
          {"height", plot.canvas().height()},
          {"x", {x.low, x.high}},
          {"y", {y.low, y.high}}};
}

QString words_of(const QWidget& widget) {
  if (const auto* label = dynamic_cast<const QLabel*>(&widget)) return label->text();
  if (const auto* button = dynamic_cast<const QAbstractButton*>(&widget)) return button->text();
  return {};
}

/// A label that wraps needs as much height as its width asks for, any other its hint.
bool is_cut(const QWidget& widget) {
  if (const auto* label = dynamic_cast<const QLabel*>(&widget); label && label->wordWrap())
    return widget.height() < widget.heightForWidth(widget.width());
  const QSize needed = widget.minimumSizeHint();
  return widget.width() < needed.width() || widget.height() < needed.height();
}

}  // namespace

nlohmann::json describe_layout(const QWidget& window) {
  nlohmann::json plots = nlohmann::json::object(), words = plots, cut = nlohmann::json::array();
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    const std::string name = widget->objectName().toStdString();
    if (const auto* plot = dynamic_cast<const TimePlot*>(widget))
      plots[name] = place_of(*plot, window);
    const QString text = words_of(*widget);
    if (text.isEmpty()) continue;
    if (!name.empty()) words[name] = text.toStdString();
    if (is_cut(*widget)) cut.push_back(text.toStdString());
  }
  return {{"plots", plots}, {"words", words}, {"cut", cut}};
}

}  // namespace searig::app::desktop
