#include "app/desktop/live/live_page.h"

#include <QAction>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <chrono>
#include <utility>

#include "app/desktop/live/calibration_panel.h"
#include "app/desktop/live/connect_panel.h"
#include "app/desktop/live/live_plots.h"
#include "app/desktop/live/record_panel.h"
#include "app/rig/as_live.h"

namespace searig::app::desktop {
namespace {

constexpr int frame_ms = 33;  // 30 frames per second

template <typename T>
bool ready(const std::future<T>& future) {
  return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

LivePage::LivePage(Shell& shell) : Page(QStringLiteral("Live"), shell) {
  make_layout();
  make_actions();
  say(
      QStringLiteral("Connect with Ctrl+R: the simulated rig, or choose your devices at the right. "
                     "A recording opens with Ctrl+O."));
  timer_.setTimerType(Qt::PreciseTimer);
  timer_.setInterval(frame_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  timer_.start();
}

/// Whoever closes the window waits until a recording is whole.
LivePage::~LivePage() {
  timer_.stop();
}

void LivePage::make_actions() {
  const auto add = [this](const char* words, const QKeySequence& key, auto action) {
    QAction* made = add_action(words, key);
    connect(made, &QAction::triggered, this, action);
    return made;
  };
  connect_ = add("&Connect", QKeySequence(int(Qt::CTRL) | Qt::Key_R),
                 [this] { connected() ? disconnect_rig() : connect_rig(); });
  record_action_ = add("&Record", QKeySequence(Qt::Key_R), [this] { toggle_recording(); });
  add("&Mark", QKeySequence(Qt::Key_M), [this] { mark(); });
  add("&Name of the recording", QKeySequence(Qt::Key_N), [this] { record_->name()->setFocus(); });
  add("N&otes kept in it", QKeySequence(int(Qt::SHIFT) | Qt::Key_N),
      [this] { record_->notes_line()->setFocus(); });
  for (QWidget* field : {record_->name(), record_->notes_line()}) hold_keys(*field);
  for (QWidget* field : choice_->fields()) hold_keys(*field);
  QAction* open = add("&Open what was recorded in Replay", QKeySequence(Qt::Key_O), [this] {
    const RecordingStatus recorded = rig_ ? rig_->recording() : RecordingStatus{};
    if (!recorded.running && !recorded.file.empty()) this->shell().open_recording(recorded.file);
  });
  add("&Take the target away", QKeySequence(Qt::Key_T), [this] { plots_->stop_leading(); });
  calibrate_ = add("Cali&brate the load cell…", QKeySequence(Qt::Key_C), [this] { calibrate(); });
  menu()->addSeparator();
  pause_ = add("&Pause (data go on)", QKeySequence(Qt::Key_Space),
               [this] { plots_->pause(pause_->isChecked()); });
  pause_->setCheckable(true);
  add("Zoom &in", QKeySequence(Qt::Key_Plus), [this] { plots_->zoom(0.5); });
  add("Zoom &out", QKeySequence(Qt::Key_Minus), [this] { plots_->zoom(2.0); });
  add("&Earlier", QKeySequence(Qt::Key_Left), [this] { plots_->move(-0.25); });
  add("&Later", QKeySequence(Qt::Key_Right), [this] { plots_->move(0.25); });
  add("&All", QKeySequence(Qt::Key_Home), [this] { plots_->show_all(); });
  connect(choice_->button(), &QPushButton::clicked, connect_, &QAction::trigger);
  connect(record_->button(), &QPushButton::clicked, record_action_, &QAction::trigger);
  connect(record_->marker(), &QPushButton::clicked, this, [this] { mark(); });
  connect(record_->open(), &QPushButton::clicked, open, &QAction::trigger);
}

void LivePage::connect_rig() {
  if (connected() || connecting_.valid()) return;
  RigOptions options;
  try {
    options = choice_->options();
  } catch (const std::exception& error) {
    return say(QString::fromUtf8(error.what()));
  }
  options.program = SEARIG_PROGRAM;
  choice_->show_state(ConnectPanel::State::connecting);
  say(QStringLiteral("Connecting…"));
  connecting_ =
      std::async(std::launch::async, [options] { return std::make_unique<RigSession>(options); });
}

void LivePage::take_rig() {
  try {
    rig_ = connecting_.get();
  } catch (const std::exception& error) {
    choice_->show_state(ConnectPanel::State::away);
    return say(QString::fromUtf8(error.what()));
  }
  has_model_ = rig_->options().model.has_value();
  marks_ = 0;
  plots_->clear();
  pause_->setChecked(false);
  news_ = {};
  choice_->show_state(ConnectPanel::State::connected);
  say({});
  shell().caption_changed();
}

void LivePage::disconnect_rig() {
  if (!connected()) return;
  close_rig();
  choice_->show_state(ConnectPanel::State::away);
  news_ = {};
  say(QStringLiteral(
      "Disconnected. What was shown stays until the next connection; Ctrl+R connects "
      "again."));
  show_numbers();
  shell().caption_changed();
}

/// Devices are let go of in the background: their threads may keep us waiting.
void LivePage::close_rig() {
  views_->setCurrentWidget(plots_);
  closing_.push_back(
      std::async(std::launch::async,
                 [rig = std::shared_ptr<RigSession>(std::move(rig_))]() mutable { rig.reset(); }));
}

void LivePage::show_as_live(const std::filesystem::path& recording, double until_s) {
  LiveNews news = as_live(recording, until_s);
  has_model_ = !news.more.t_s.empty();
  shown_ = true;
  plots_->clear();
  plots_->take(news);
  plots_->draw();
  note_events(news);
  news_ = std::move(news);
  say({});
  show_numbers();
}

void LivePage::toggle_recording() {
  if (!connected()) return say(QStringLiteral("Connect first, with Ctrl+R; then R records."));
  if (rig_->recording().running) return rig_->stop_recording();
  try {
    std::filesystem::create_directories(record_->folder());
    rig_->start_recording(record_->next_file(), record_->notes());
    say({});
  } catch (const std::exception& error) {
    say(QString::fromUtf8(error.what()));
  }
}

bool LivePage::lead(const estimator::PlannedMotion& motion) {
  if (!connected()) return false;
  views_->setCurrentWidget(plots_);
  plots_->lead(motion);
  show_hint();
  return true;
}

void LivePage::mark() {
  if (!connected() || !rig_->recording().running)
    return say(QStringLiteral("A mark goes into a recording: start one with R."));
  const std::string words = "mark " + std::to_string(++marks_);
  rig_->mark(words);
  plots_->mark(words);
}

void LivePage::calibrate() {
  if (!connected()) return say(QStringLiteral("Connect the load cell first, with Ctrl+R."));
  calibration_->begin(record_->folder(), rig_->options().lever_arm_m.value_or(1.0));
  views_->setCurrentWidget(calibration_);
  show_hint();
}

void LivePage::tick() {
  if (connecting_.valid() && ready(connecting_)) take_rig();
  std::erase_if(closing_, [](const auto& closing) { return ready(closing); });
  if (again_ && closing_.empty()) {
    again_ = false;
    connect_rig();
  }
  if (!connected()) return;
  LiveNews news = rig_->news();
  note_events(news);
  plots_->take(news);
  if (views_->currentWidget() == calibration_)
    calibration_->take(news, *rig_);
  else if (isVisible() && !plots_->paused())
    plots_->draw();
  news.more = {};
  news_ = std::move(news);
  if (frames_++ % 6 == 0) show_numbers();  // faster nobody reads
}

QString LivePage::caption() const {
  return connected() ? QStringLiteral("Live") : QString();
}

void LivePage::set_theme(const Theme& theme) {
  theme_ = theme;
  plots_->set_theme(theme);
  show_numbers();
}

}  // namespace searig::app::desktop
