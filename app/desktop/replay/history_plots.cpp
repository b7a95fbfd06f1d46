// The plots of a recording, and what is drawn in them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/desktop/plot/regime_dots.h"
#include "app/desktop/replay/history_view.h"

namespace searig::app::desktop {
namespace {

enum Curve : std::size_t { measured, first_torque, second_torque };
enum Run : std::size_t { first, second };

/// Twice what 19 of 20 stay below, about zero: the first seconds of a first guess that was ten
/// times too high would flatten the rest.
Range range_for(const RegimeResiduals& residuals) {
  std::vector<double> sizes;
  for (const auto& each : residuals)
    for (const double nm : each.nm)
      if (std::isfinite(nm)) sizes.push_back(std::abs(nm));
  if (sizes.empty()) return {-1.0, 1.0};
  const auto at = sizes.begin() + std::ptrdiff_t(0.95 * double(sizes.size() - 1));
  std::ranges::nth_element(sizes, at);
  const double high = std::max(2.0 * *at, 1e-12);
  return {-high, high};
}

}  // namespace

void HistoryView::make_plots() {
  torque_ = new TimePlot(QStringLiteral("Torque"), QStringLiteral("torque (N·m)"), this);
  torque_->setObjectName(QStringLiteral("torque"));
  torque_->add_curve(QStringLiteral("measured by the load cell"), Hue::ink);
  torque_->add_curve(QStringLiteral("estimated from the spring"), Hue::blue);
  torque_->add_curve({}, Hue::vermilion);
  torque_->follow_y(measured);  // not a first guess of k that is ten times too high
  residual_ =
      new TimePlot(QStringLiteral("Measured − estimated"), QStringLiteral("torque (N·m)"), this);
  residual_->setObjectName(QStringLiteral("residual"));
  add_regime_dots(*residual_);
  weight_ = new TimePlot(QStringLiteral("Trust in the motor current"),
                         QStringLiteral("weight (0 to 1)"), this);
  weight_->setObjectName(QStringLiteral("weight"));
  weight_->add_curve(QStringLiteral("weight"), Hue::purple);
  weight_->add_curve({}, Hue::vermilion);
  weight_->fix_y({-0.05, 1.05});
  stiffness_ =
      new TimePlot(QStringLiteral("Spring stiffness"), QStringLiteral("k (N·m/rad)"), this);
  stiffness_->setObjectName(QStringLiteral("stiffness"));
  stiffness_->add_curve(QStringLiteral("online estimate"), Hue::green);
  stiffness_->add_curve({}, Hue::vermilion);
}

void HistoryView::show_histories(const History* one, const History* other) {
  first_ = one;
  second_ = other;
  static const History none;
  const History& over = other ? *other : none;
  torque_->set_data(measured, &one->measured_t_s, &one->measured_nm);
  torque_->set_data(first_torque, &one->t_s, &one->estimated_nm);
  torque_->set_data(second_torque, &over.t_s, &over.estimated_nm);
  weight_->set_data(first, &one->t_s, &one->weight);
  weight_->set_data(second, &over.t_s, &over.weight);
  stiffness_->set_data(first, &one->t_s, &one->stiffness_nm_per_rad);
  stiffness_->set_data(second, &over.t_s, &over.stiffness_nm_per_rad);
  torque_->rename_curve(first_torque, QString::fromStdString(one->estimated_from));
  const QString name = other ? QString::fromStdString(over.estimated_from) : QString();
  torque_->rename_curve(second_torque, name);
  weight_->rename_curve(second, over.weight.empty() ? QString() : name);
  stiffness_->rename_curve(second, over.stiffness_nm_per_rad.empty() ? QString() : name);
  weight_->setVisible(!one->weight.empty() || !over.weight.empty());
  stiffness_->setVisible(!one->stiffness_nm_per_rad.empty() || !over.stiffness_nm_per_rad.empty());
  show_residuals({});
}

/// The lowest plot that is there has the time axis.
void HistoryView::show_residuals(RegimeResiduals residuals) {
  residuals_ = std::move(residuals);
  set_regime_dots(*residual_, residuals_);
  residual_->fix_y(range_for(residuals_));
  residual_->setVisible(
      std::ranges::any_of(residuals_, [](const auto& each) { return !each.t_s.empty(); }));
  TimePlot* lowest = torque_;
  for (TimePlot* plot : plots()) {
    plot->show_time_axis(false);
    if (!plot->isHidden()) lowest = plot;
  }
  lowest->show_time_axis(true);
  show_range(range_);
}

void HistoryView::shade(const std::vector<Interval>& intervals, const QString& name) {
  shaded_ = intervals;
  shaded_name_ = name;
  torque_->set_shaded(intervals, name);
  residual_->set_shaded(intervals, {});
  show_range(range_);
}

void HistoryView::set_theme(const Theme& theme) {
  for (TimePlot* plot : plots()) plot->set_theme(theme);
  set_cursors(cursors_);  // in the new colours, as the shading
  shade(std::vector<Interval>(shaded_), shaded_name_);
}

}  // namespace searig::app::desktop
