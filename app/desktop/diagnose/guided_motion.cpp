#include "app/desktop/diagnose/guided_motion.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/desktop/plot/time_plot.h"
#include "app/report/axis.h"
#include "app/report/quantity.h"

namespace searig::app::desktop {
namespace {

constexpr double target_hz = 100.0;
constexpr int frame_ms = 33;
constexpr double countdown_s = 3.0;
constexpr double ahead_s = 8.0, behind_s = 2.0;  // of the target, while it is followed

QString said(double value, int decimals) {
  return QString::fromStdString(number(value, decimals));
}

}  // namespace

GuidedMotion::GuidedMotion(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel(this)),
      steps_(new QLabel(this)),
      now_(new QLabel(this)),
      plot_(new TimePlot(QStringLiteral("Target"), QStringLiteral("angle (rad)"), this)),
      start_(new QPushButton(QStringLiteral("Start   Space"), this)),
      save_(new QPushButton(QStringLiteral("Save for the rig…"), this)),
      close_(new QPushButton(QStringLiteral("Back   N"), this)) {
  title_->setObjectName(QStringLiteral("experiment"));
  steps_->setObjectName(QStringLiteral("steps"));
  now_->setObjectName(QStringLiteral("target"));
  plot_->setObjectName(QStringLiteral("guided"));
  start_->setObjectName(QStringLiteral("start_motion"));
  plot_->add_curve(QStringLiteral("deflection of the spring"), Hue::blue);
  plot_->add_curve({}, Hue::orange);
  for (QLabel* label : {title_, steps_}) label->setWordWrap(true);
  QFont large = now_->font();
  large.setPointSizeF(20.0);
  large.setBold(true);
  now_->setFont(large);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {start_, save_, close_}) {
    button->setFocusPolicy(Qt::NoFocus);
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 8, 14, 8);
  layout->setSpacing(10);
  layout->addWidget(title_);
  layout->addWidget(steps_);
  layout->addWidget(now_);
  layout->addWidget(plot_, 1);
  layout->addLayout(buttons);
  timer_.setInterval(frame_ms);
  connect(&timer_, &QTimer::timeout, this,
          [this] { show_time(1e-3 * double(since_start_.elapsed())); });
  connect(start_, &QPushButton::clicked, this, [this] { toggle(); });
}

void GuidedMotion::show_motion(const estimator::PlannedMotion& motion, const QString& why) {
  motion_ = motion;
  target_ = estimator::angles_of(motion, target_hz);
  const bool swings = motion.output_rad > 0.0;
  title_->setText(QStringLiteral("<b>The next experiment: %1.</b> %2")
                      .arg(QString::fromStdString(capital(estimator::words_for(motion))), why));
  steps_->setText(
      QStringLiteral("1. Go to Live (Ctrl+1), connect and begin to record.<br>"
                     "2. %1<br>"
                     "3. Come back and press Space: Live then shows the target beside how the "
                     "module moves, and you lead it along. Or save the motion and let the rig's "
                     "controller follow it.<br>"
                     "4. End the recording, open it, and diagnose it with the extended model.")
          .arg(swings ? QStringLiteral("Let the lever swing along the orange target.")
                      : QStringLiteral("Lock the lever: only the spring is to move.")));
  plot_->set_data(0, &target_.t_s, &target_.deflection_rad);
  if (!swings) target_.output_angle_rad.clear();
  plot_->set_data(1, &target_.t_s, &target_.output_angle_rad);
  plot_->rename_curve(1, swings ? QStringLiteral("angle of the lever") : QString());
  stop();
}

void GuidedMotion::toggle() {
  if (running()) return stop();
  if (!lead_ || !lead_(motion_)) start();
}

void GuidedMotion::start() {
  since_start_.start();
  timer_.start();
  start_->setText(QStringLiteral("Stop   Space"));
  show_time(0.0);
}

void GuidedMotion::stop() {
  timer_.stop();
  start_->setText(QStringLiteral("Start   Space"));
  now_->setText(QStringLiteral("%1 s in all").arg(said(motion_.seconds, 0)));
  plot_->set_marks({});
  plot_->show_range({0.0, motion_.seconds});
}

void GuidedMotion::show_time(double t_s) {
  const double into_s = t_s - countdown_s;
  if (into_s > motion_.seconds) {
    stop();
    now_->setText(QStringLiteral("Done. End the recording on Live (Ctrl+1) and open it."));
    return;
  }
  say_target(into_s);
  plot_->set_marks({{into_s, "now", Hue::vermilion}});
  plot_->show_range({into_s - behind_s, into_s + ahead_s});
}

void GuidedMotion::say_target(double into_s) {
  if (into_s < 0.0) {
    now_->setText(QStringLiteral("Begins in %1 s").arg(said(std::ceil(-into_s), 0)));
    return;
  }
  const auto i = std::min(target_.deflection_rad.size() - 1, std::size_t(into_s * target_hz));
  now_->setText(
      QStringLiteral("Spring to %1 rad,  %2 s to go")
          .arg(said(target_.deflection_rad[i], 2), said(std::ceil(motion_.seconds - into_s), 0)));
}

void GuidedMotion::on_close(std::function<void()> close) {
  connect(close_, &QPushButton::clicked, this, std::move(close));
}

void GuidedMotion::on_save(std::function<void()> save) {
  connect(save_, &QPushButton::clicked, this, std::move(save));
}

void GuidedMotion::set_theme(const Theme& theme) {
  plot_->set_theme(theme);
}

}  // namespace searig::app::desktop
