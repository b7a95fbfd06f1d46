#include "app/desktop/work_bar.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

namespace searig::app::desktop {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto between_words = std::chrono::milliseconds(50);  // the eye reads no faster

}  // namespace

/// The bar outlives its tasks: it joins their threads.
struct WorkBar::Progress::Task {
  WorkBar* bar;
  std::atomic<bool> stopped{false}, over{false};
  Clock::time_point said = {};  // the work's thread only
};

void WorkBar::Progress::show(std::function<void()> call) const {
  QMetaObject::invokeMethod(
      task_->bar,
      [task = task_, call = std::move(call)] {
        if (!task->stopped) call();
      },
      Qt::QueuedConnection);
}

bool WorkBar::Progress::operator()(const std::string& doing, double share) const {
  if (const auto now = Clock::now(); now - task_->said >= between_words) {
    task_->said = now;
    show([=, bar = task_->bar] { bar->show_progress(doing, share); });
  }
  return !task_->stopped;
}

WorkBar::WorkBar(QWidget* parent)
    : QWidget(parent),
      doing_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      stop_(new QPushButton(QStringLiteral("Stop   Esc"), this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 4, 14, 4);
  layout->addWidget(bar_);
  layout->addWidget(stop_);
  layout->addWidget(doing_, 1);
  bar_->setFixedWidth(220);
  doing_->setObjectName(QStringLiteral("doing"));
  stop_->setObjectName(QStringLiteral("stop"));
  stop_->setFocusPolicy(Qt::NoFocus);
  connect(stop_, &QPushButton::clicked, this, [this] { cancel(); });
  hide();
}

WorkBar::~WorkBar() {
  changed_ = nullptr;
  cancel();  // the threads are joined as running_ goes
}

void WorkBar::start(const QString& doing, Work work, Failed failed) {
  cancel();
  drop_what_is_over();
  Progress progress;
  auto task = current_ = progress.task_ = std::make_shared<Task>();
  task->bar = this;
  show_progress(doing.toStdString(), -1.0);
  show();
  auto run = [=, this, work = std::move(work), failed = std::move(failed)] {
    std::function<void()> show_results;
    QString why;
    try {
      show_results = work(progress);
    } catch (const std::exception& error) {
      why = QString::fromUtf8(error.what());
    }
    progress.show([=, this] {
      finish();
      show_results ? show_results() : failed(why);
    });
    task->over = true;
  };
  running_.push_back({task, std::jthread(std::move(run))});
  if (changed_) changed_();
}

void WorkBar::cancel() {
  if (!current_) return;
  current_->stopped = true;
  finish();
}

void WorkBar::wait() {
  while (busy()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

void WorkBar::finish() {
  current_ = nullptr;
  hide();
  if (changed_) changed_();
}

void WorkBar::show_progress(const std::string& doing, double share) {
  bar_->setRange(0, share < 0.0 ? 0 : 100);
  if (share >= 0.0) bar_->setValue(int(std::lround(100.0 * share)));
  QString words = QString::fromStdString(doing);
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  doing_->setText(words);
}

void WorkBar::drop_what_is_over() {
  running_.remove_if([](const Running& running) { return running.task->over.load(); });
}

}  // namespace searig::app::desktop
