// The motion that a user is led through, beside the motion that there is.
#include <algorithm>

#include "app/desktop/live/live_plots.h"
#include "app/desktop/plot/time_plot.h"

namespace searig::app::desktop {
namespace {

enum Curve : std::size_t { target_deflection, target_lever, deflection, lever };
constexpr double target_hz = 100.0, countdown_s = 3.0, behind_s = 6.0, ahead_s = 6.0;

}  // namespace

void LivePlots::make_target() {
  target_plot_ =
      new TimePlot(QStringLiteral("Follow the target"), QStringLiteral("angle (rad)"), this);
  target_plot_->setObjectName(QStringLiteral("target"));
  target_plot_->add_curve(QStringLiteral("target of the spring"), Hue::sky);
  target_plot_->add_curve({}, Hue::orange);
  target_plot_->add_curve(QStringLiteral("deflection"), Hue::blue);
  target_plot_->add_curve({}, Hue::vermilion);
  target_plot_->hide();
}

void LivePlots::connect_target() {
  target_plot_->set_data(deflection, &columns_.t_s, &columns_.deflection_rad);
  target_plot_->set_data(lever, &columns_.t_s, &columns_.output_angle_rad);
}

void LivePlots::lead(const estimator::PlannedMotion& motion) {
  target_ = estimator::angles_of(motion, target_hz);
  lead_from_s_ = now_s_ + countdown_s;
  lead_s_ = motion.seconds;
  for (double& t : target_.t_s) t += *lead_from_s_;
  const bool swings = motion.output_rad > 0.0;
  if (!swings) target_.output_angle_rad.clear();
  target_plot_->set_data(target_deflection, &target_.t_s, &target_.deflection_rad);
  target_plot_->set_data(target_lever, &target_.t_s, &target_.output_angle_rad);
  target_plot_->rename_curve(target_lever,
                             swings ? QStringLiteral("target of the lever") : QString());
  target_plot_->rename_curve(lever, swings ? QStringLiteral("angle of the lever") : QString());
  make_room(true);
  draw();
}

/// The eye is on the target; what it leaves alone makes room.
void LivePlots::make_room(bool for_target) {
  target_plot_->setVisible(for_target);
  residual_->setVisible(!for_target);
  weight_->setVisible(!for_target);
}

void LivePlots::stop_leading() {
  lead_from_s_.reset();
  make_room(false);
}

/// What is to come is in view, too. It goes by itself when the motion is over.
void LivePlots::draw_target() {
  if (now_s_ > *lead_from_s_ + lead_s_ + countdown_s) return stop_leading();
  target_plot_->set_marks({{now_s_, "now", Hue::vermilion}});
  target_plot_->show_range({now_s_ - behind_s, now_s_ + ahead_s});
}

}  // namespace searig::app::desktop
