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
  auto task = std::make_shared<Task>();
  current_ = task;
  show_progress(task, doing.toStdString(), -1.0);
  show();
  const auto on_window = [this](std::function<void()> call) {
    QMetaObject::invokeMethod(this, std::move(call), Qt::QueuedConnection);
  };
  const Progress progress = [this, task, on_window, last = Clock::time_point{}](
                                const std::string& words, double share) mutable {
    if (const auto now = Clock::now(); now - last >= between_words) {
      last = now;
      on_window([=, this] { show_progress(task, words, share); });
    }
    return !task->stopped;
  };
  auto run = [=, this, work = std::move(work), failed = std::move(failed)] {
    std::function<void()> show_results;
    QString why;
    try {
      show_results = work(progress);
    } catch (const std::exception& error) {
      why = QString::fromUtf8(error.what());
    }
    on_window([=, this] {
      if (task->stopped) return;
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

void WorkBar::show_progress(const std::shared_ptr<Task>& task, const std::string& doing,
                            double share) {
  if (task != current_) return;
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
