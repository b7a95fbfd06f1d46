#include "app/desktop/plot/time_mouse.h"

#include <QMouseEvent>
#include <QRubberBand>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "app/desktop/plot/time_plot.h"

namespace searig::app::desktop {
namespace {

constexpr int hand_shakes_px = 4;       // a drag shorter than this was a click
constexpr double notch = 120.0;         // of a wheel, as Qt counts
constexpr double closer_a_notch = 0.8;  // of the time shown

TimePlot& plot_of(QObject* canvas) {
  return *static_cast<TimePlot*>(canvas->property("plot").value<void*>());
}

}  // namespace

TimeMouse::TimeMouse(QObject* parent, Calls calls) : QObject(parent), calls_(std::move(calls)) {}

void TimeMouse::watch(TimePlot& plot) {
  plot.canvas().setProperty("plot", QVariant::fromValue(static_cast<void*>(&plot)));
  plot.canvas().setCursor(Qt::CrossCursor);
  plot.canvas().installEventFilter(this);
}

bool TimeMouse::eventFilter(QObject* canvas, QEvent* event) {
  TimePlot& plot = plot_of(canvas);
  const auto* mouse = dynamic_cast<QMouseEvent*>(event);
  if (event->type() == QEvent::Wheel) {
    const auto* wheel = static_cast<QWheelEvent*>(event);
    const double notches = (wheel->angleDelta().y() + wheel->angleDelta().x()) / notch;
    if (wheel->modifiers() & Qt::ShiftModifier)
      calls_.move(-0.1 * notches);
    else
      calls_.zoom(std::pow(closer_a_notch, notches), plot.time_at(int(wheel->position().x())));
    return true;
  }
  if (!mouse || (mouse->button() != Qt::LeftButton && event->type() != QEvent::MouseMove))
    return false;
  const bool second = mouse->modifiers() & Qt::ShiftModifier;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      pressed_ = mouse->pos();
      if (!band_) band_ = new QRubberBand(QRubberBand::Rectangle);
      band_->setParent(&plot.canvas());
      return true;
    case QEvent::MouseMove:
      if (!(mouse->buttons() & Qt::LeftButton) || !band_) return false;
      band_->setGeometry(std::min(pressed_.x(), mouse->x()), 0, std::abs(mouse->x() - pressed_.x()),
                         plot.canvas().height());
      band_->setVisible(std::abs(mouse->x() - pressed_.x()) >= hand_shakes_px);
      return true;
    case QEvent::MouseButtonRelease:
      return release(plot, mouse->pos(), second);
    case QEvent::MouseButtonDblClick:
      calls_.show_all();
      return true;
    default:
      return false;
  }
}

bool TimeMouse::release(TimePlot& plot, QPoint at, bool second) {
  if (!band_) return false;  // the press of a double click
  delete std::exchange(band_, nullptr);
  const int left = std::min(pressed_.x(), at.x()), right = std::max(pressed_.x(), at.x());
  if (right - left >= hand_shakes_px)
    calls_.show({plot.time_at(left), plot.time_at(right)});
  else
    calls_.click(plot.time_at(at.x()), second);
  return true;
}

}  // namespace searig::app::desktop
