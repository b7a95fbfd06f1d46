// Hands Qwt no more points than the screen has pixels for. The one place where Qwt meets the data.
#pragma once

#include <qwt_series_data.h>

#include <QPointF>
#include <vector>

namespace searig::app::desktop {

class DecimatedSeries : public QwtSeriesData<QPointF> {
 public:
  /// The columns stay with their owner, which keeps them alive and may only append between calls.
  void show(const std::vector<double>* x, const std::vector<double>* y);
  /// Chooses the points anew for what is visible.
  void choose(double low, double high, int pixel_columns);

  size_t size() const override { return points_.size(); }
  QPointF sample(size_t i) const override { return points_[i]; }
  QRectF boundingRect() const override { return bounds_; }

 private:
  const std::vector<double>* x_ = nullptr;
  const std::vector<double>* y_ = nullptr;
  std::vector<QPointF> points_;
  QRectF bounds_;
};

}  // namespace searig::app::desktop
