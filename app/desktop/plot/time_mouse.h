// What a mouse means on plots that share a time axis.
#pragma once

#include <QObject>
#include <QPoint>
#include <functional>

#include "app/report/plot.h"

class QRubberBand;

namespace searig::app::desktop {

class TimePlot;

/// Wheel: closer or further about the pointer; with Shift: earlier or later. A drag: what it spans.
/// A click: the time under it, with Shift the second one. A double click: everything.
class TimeMouse : public QObject {
 public:
  struct Calls {
    std::function<void(double factor, double at_s)> zoom;
    std::function<void(double share)> move;
    std::function<void(Range time_s)> show;
    std::function<void(double at_s, bool second)> click;
    std::function<void()> show_all;
  };

  TimeMouse(QObject* parent, Calls calls);
  void watch(TimePlot& plot);

 protected:
  bool eventFilter(QObject* canvas, QEvent* event) override;

 private:
  bool release(TimePlot& plot, QPoint at, bool second);

  Calls calls_;
  QRubberBand* band_ = nullptr;
  QPoint pressed_;
};

}  // namespace searig::app::desktop
