#include "app/desktop/live/live_plots.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/desktop/plot/regime_dots.h"
#include "app/desktop/plot/time_plot.h"

namespace searig::app::desktop {
namespace {

constexpr double kept_s = 600.0, kept_paused_s = 3600.0;
constexpr double forget_every_s = 20.0;  // letting go of data begins all plots anew
enum Torque : std::size_t { by_clock, interval, measured, estimated, newest };

}  // namespace

LivePlots::LivePlots(QWidget* parent) : QWidget(parent) {
  make_plots();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(target_plot_, 10);
  layout->addWidget(torque_, 10);
  layout->addWidget(residual_, 6);
  layout->addWidget(weight_, 4);
  layout->addWidget(stiffness_, 7);
  for (auto* plot : {torque_, residual_, weight_}) plot->show_time_axis(false);
  connect_columns();
  draw();
}

void LivePlots::make_plots() {
  make_target();
  torque_ = new TimePlot(QStringLiteral("Torque"), QStringLiteral("torque (N·m)"), this);
  torque_->setObjectName(QStringLiteral("torque"));
  torque_->add_band(QStringLiteral("and what the clocks add"), Hue::orange, 0.35);
  torque_->add_band(QStringLiteral("its 95 % interval"), Hue::sky, 0.45);
  torque_->add_curve(QStringLiteral("measured"), Hue::ink);
  torque_->add_curve(QStringLiteral("estimated"), Hue::blue);
  torque_->add_curve({}, Hue::blue);
  residual_ =
      new TimePlot(QStringLiteral("Measured − estimated"), QStringLiteral("torque (N·m)"), this);
  residual_->setObjectName(QStringLiteral("residual"));
  add_regime_dots(*residual_);
  weight_ = new TimePlot(QStringLiteral("Trust in the motor current"), QStringLiteral("weight (–)"),
                         this);
  weight_->setObjectName(QStringLiteral("weight"));
  weight_->add_curve({}, Hue::purple);
  weight_->fix_y({-0.05, 1.05});
  stiffness_ =
      new TimePlot(QStringLiteral("Spring stiffness"), QStringLiteral("k (N·m/rad)"), this);
  stiffness_->setObjectName(QStringLiteral("stiffness"));
  stiffness_->add_band(QStringLiteral("95 % interval of the linear estimator"), Hue::sky, 0.45);
  stiffness_->add_curve(QStringLiteral("online estimate"), Hue::green);
}

/// Again whenever the columns begin elsewhere.
void LivePlots::connect_columns() {
  const LiveColumns& c = columns_;
  torque_->set_band(by_clock, &c.t_s, &c.clock_low_nm, &c.clock_high_nm);
  torque_->set_band(interval, &c.t_s, &c.low_nm, &c.high_nm);
  torque_->set_data(measured, &c.loadcell_t_s, &c.loadcell_nm);
  torque_->set_data(estimated, &c.t_s, &c.torque_nm);
  set_regime_dots(*residual_, c.residuals);
  connect_target();
  weight_->set_data(0, &c.t_s, &c.weight);
  stiffness_->set_band(0, &c.t_s, &c.k_low_nm_per_rad, &c.k_high_nm_per_rad);
  stiffness_->set_data(1, &c.t_s, &c.k_nm_per_rad);
}

void LivePlots::take(LiveNews& news) {
  columns_.append(news.more);
  now_s_ = news.now_s;
  if (!news.tail_t_s.empty()) {
    tail_t_s_ = std::move(news.tail_t_s);
    tail_nm_ = std::move(news.tail_nm);
  }
  const double keep_s = paused_ ? kept_paused_s : kept_s;
  const auto& t_s = columns_.t_s.empty() ? columns_.loadcell_t_s : columns_.t_s;
  if (!t_s.empty() && t_s.front() < now_s_ - keep_s - forget_every_s &&
      columns_.forget_before(now_s_ - keep_s))
    connect_columns();
}

void LivePlots::draw() {
  if (!paused_) {
    const double end_s = std::max(span_s_, now_s_);
    range_ = {end_s - span_s_, end_s};
  }
  torque_->set_data(newest, &tail_t_s_, &tail_nm_);  // another each time
  if (!columns_.k_nm_per_rad.empty()) stiffness_->follow_y_about(columns_.k_nm_per_rad.back());
  for (auto* plot : plots()) plot->show_range(range_);
  if (leading()) draw_target();
}

void LivePlots::clear() {
  columns_ = {};
  tail_t_s_.clear();
  tail_nm_.clear();
  marks_.clear();
  now_s_ = 0.0;
  paused_ = false;
  stop_leading();
  connect_columns();
  show_marks();
  draw();
}

void LivePlots::pause(bool on) {
  if (paused_ && !on) span_s_ = std::clamp(range_.high - range_.low, 1.0, kept_s);
  paused_ = on;
}

void LivePlots::zoom(double factor) {
  if (!paused_) {
    span_s_ = std::clamp(span_s_ * factor, 1.0, kept_s);
  } else {
    const double half = 0.5 * std::clamp((range_.high - range_.low) * factor, 0.05, kept_paused_s);
    const double centre = 0.5 * (range_.low + range_.high);
    range_ = {centre - half, centre + half};
  }
  draw();
}

void LivePlots::move(double share) {
  if (!paused_) return;
  const double by = share * (range_.high - range_.low);
  range_ = {range_.low + by, range_.high + by};
  draw();
}

void LivePlots::show_all() {
  const double begin_s = columns_.t_s.empty() ? 0.0 : columns_.t_s.front();
  span_s_ = std::clamp(now_s_ - begin_s, 1.0, kept_s);
  if (paused_) range_ = {begin_s, std::max(begin_s + 1.0, now_s_)};
  draw();
}

void LivePlots::mark(const std::string& words) {
  marks_.push_back({now_s_, words, Hue::vermilion});
  show_marks();
}

/// The words stand in the uppermost plot alone.
void LivePlots::show_marks() {
  std::vector<Mark> lines = marks_;
  for (Mark& line : lines) line.text.clear();
  for (auto* plot : plots()) plot->set_marks(plot == torque_ ? marks_ : lines);
}

void LivePlots::set_theme(const Theme& theme) {
  for (auto* plot : plots()) plot->set_theme(theme);
  target_plot_->set_theme(theme);
  show_marks();  // in the new colours
  draw();
}

}  // namespace searig::app::desktop
