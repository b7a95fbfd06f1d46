#include "app/desktop/live/live_page.h"

#include <QAction>
#include <QMenu>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/desktop/replay/history_view.h"

namespace searig::app::desktop {
namespace {

constexpr int frame_ms = 33;  // 30 frames per second

}  // namespace

LivePage::LivePage(Shell& shell)
    : Page(QStringLiteral("Live"), shell), view_(new HistoryView(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(view_);
  view_->say(
      QStringLiteral("Start the simulated rig with Ctrl+R, or open a recording with Ctrl+O."));
  make_actions();
  timer_.setInterval(frame_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
}

void LivePage::make_actions() {
  const auto add = [this](const char* words, const QKeySequence& key, auto action) {
    QAction* made = add_action(words, key);
    connect(made, &QAction::triggered, this, action);
    return made;
  };
  add("&Simulated rig", QKeySequence(int(Qt::CTRL) | Qt::Key_R), [this] { start_simulated(); });
  pause_ = add("&Pause (data go on)", QKeySequence(Qt::Key_Space), [this] {
    const Range range = view_->range();
    if (!pause_->isChecked()) span_s_ = std::clamp(range.high - range.low, 1.0, 600.0);
  });
  pause_->setCheckable(true);
  pause_->setEnabled(false);
  menu()->addSeparator();
  add("Zoom &in", QKeySequence(Qt::Key_Plus), [this] { zoom(0.5); });
  add("Zoom &out", QKeySequence(Qt::Key_Minus), [this] { zoom(2.0); });
  add("&Earlier", QKeySequence(Qt::Key_Left), [this] {
    if (!following()) view_->move(-0.25);
  });
  add("&Later", QKeySequence(Qt::Key_Right), [this] {
    if (!following()) view_->move(0.25);
  });
  add("&All", QKeySequence(Qt::Key_Home), [this] { view_->show_all(); });
}

bool LivePage::following() const {
  return rig_ && !pause_->isChecked();
}

void LivePage::start_simulated(double ahead_s) {
  timer_.stop();
  auto rig = std::make_unique<LiveRig>();
  view_->show_history(&rig->history(), true);
  rig_ = std::move(rig);  // the view has let go of the old one's columns
  ahead_s_ = ahead_s;
  pause_->setEnabled(true);
  pause_->setChecked(false);
  view_->say({});
  // As many steps as a live view would have taken, so that both show the same.
  for (double t = 0.0; t < ahead_s; t += 1e-3 * frame_ms) rig_->run_until(t);
  since_start_.start();
  timer_.start();
  tick();
  shell().caption_changed();
}

void LivePage::tick() {
  rig_->run_until(ahead_s_ + 1e-3 * static_cast<double>(since_start_.elapsed()));
  view_->show_numbers(rig_->recording(), rig_->clock(), true);
  if (!following()) return;
  const auto& t_s = rig_->history().t_s;
  const double until_s = std::max(span_s_, t_s.empty() ? 0.0 : t_s.back());
  view_->show_range({until_s - span_s_, until_s});
}

void LivePage::zoom(double factor) {
  if (following())
    span_s_ = std::clamp(span_s_ * factor, 1.0, 600.0);
  else
    view_->zoom(factor);
}

QString LivePage::caption() const {
  return rig_ ? QStringLiteral("Simulated rig") : QString();
}

QString LivePage::message() const {
  return view_->said();
}

void LivePage::set_theme(const Theme& theme) {
  view_->set_theme(theme);
}

}  // namespace searig::app::desktop
