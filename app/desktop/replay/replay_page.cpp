#include "app/desktop/replay/replay_page.h"

#include <QAction>
#include <QCursor>
#include <QLabel>
#include <QMenu>
#include <QVBoxLayout>
#include <utility>

#include "app/desktop/plot/time_plot.h"
#include "app/desktop/replay/cursor_table.h"
#include "app/desktop/replay/history_view.h"
#include "app/desktop/replay/run_panel.h"
#include "app/desktop/work_bar.h"

namespace searig::app::desktop {
namespace {

constexpr int side_px = 300;

QKeySequence with(Qt::Modifier modifier, Qt::Key key) {
  return QKeySequence(int(modifier) | int(key));
}

}  // namespace

ReplayPage::ReplayPage(Shell& shell)
    : Page(QStringLiteral("Replay"), shell),
      work_(new WorkBar(this)),
      view_(new HistoryView(this)),
      cursors_(new CursorTable(this)),
      runs_(new RunPanel(this)) {
  auto* beside = new QWidget(this);
  auto* side = new QVBoxLayout(beside);
  side->setContentsMargins(8, 14, 14, 8);
  side->setSpacing(18);
  side->addWidget(cursors_);
  auto* keys = new QLabel(QStringLiteral("A click or the key A sets A; Shift and a click, or B, "
                                         "sets B. Drag to enlarge, wheel to zoom."),
                          this);
  keys->setWordWrap(true);
  keys->setEnabled(false);  // the palette's fainter text
  side->addWidget(keys);
  side->addWidget(runs_);
  side->addStretch(1);
  for (QWidget* widget :
       {static_cast<QWidget*>(cursors_), static_cast<QWidget*>(runs_), static_cast<QWidget*>(keys)})
    widget->setFixedWidth(side_px);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(work_);
  view_->put_beside(beside);
  layout->addWidget(view_, 1);
  view_->say(QStringLiteral("Open a recording with Ctrl+O, or drop one on the window."));
  view_->on_cursors([this] {
    cursors_->show_values(view_->cursors(), first_ ? &first_->history : nullptr,
                          second_ ? &second_->history : nullptr);
  });
  runs_->on_run([this] { run_again(); });
  runs_->on_take_away([this] { show_runs(first_, nullptr); });
  make_actions();
  view_->set_cursors({});
}

void ReplayPage::make_actions() {
  const auto add = [this](const char* words, const QKeySequence& key, auto action) {
    connect(add_action(words, key), &QAction::triggered, this, action);
  };
  add("Zoom &in", QKeySequence(Qt::Key_Plus), [this] { view_->zoom(0.5); });
  add("Zoom &out", QKeySequence(Qt::Key_Minus), [this] { view_->zoom(2.0); });
  add("&Earlier", QKeySequence(Qt::Key_Left), [this] { view_->move(-0.25); });
  add("&Later", QKeySequence(Qt::Key_Right), [this] { view_->move(0.25); });
  add("&Whole recording", QKeySequence(Qt::Key_Home), [this] { view_->show_all(); });
  add("Bac&k to where it was", QKeySequence(Qt::Key_Backspace), [this] { view_->back(); });
  menu()->addSeparator();
  add("Cursor &A here", QKeySequence(Qt::Key_A), [this] { set_cursor(false); });
  add("Cursor &B here", QKeySequence(Qt::Key_B), [this] { set_cursor(true); });
  add("A a bit earlier", with(Qt::SHIFT, Qt::Key_Left), [this] { step_cursor(false, -1); });
  add("A a bit later", with(Qt::SHIFT, Qt::Key_Right), [this] { step_cursor(false, 1); });
  add("B a bit earlier", with(Qt::ALT, Qt::Key_Left), [this] { step_cursor(true, -1); });
  add("B a bit later", with(Qt::ALT, Qt::Key_Right), [this] { step_cursor(true, 1); });
  add("&No cursors", QKeySequence(Qt::Key_C), [this] { view_->set_cursors({}); });
  menu()->addSeparator();
  add("&Run the estimator again", QKeySequence(Qt::Key_R), [this] { run_again(); });
  add("&Take the second run away", QKeySequence(Qt::Key_X), [this] { show_runs(first_, nullptr); });
  add("&Stop reading or estimating", QKeySequence(Qt::Key_Escape), [this] {
    if (!work_->busy()) return;
    work_->cancel();
    view_->say(QStringLiteral("Stopped. R runs the estimator, Ctrl+O opens a recording."));
  });
}

void ReplayPage::open(const std::filesystem::path& recording,
                      std::function<void(std::shared_ptr<const Session>)> opened) {
  view_->say({});
  work_->start(
      QStringLiteral("Reading %1").arg(QString::fromStdString(recording.filename().string())),
      [=, this](const WorkBar::Progress&) -> std::function<void()> {
        auto session = std::make_shared<const Session>(open_session(recording));
        return [=, this] {
          show_session(session);
          if (opened) opened(session);
        };
      },
      [this](const QString& why) { view_->say(why); });
}

/// What was measured is there before the estimate is.
void ReplayPage::show_session(std::shared_ptr<const Session> session) {
  auto measured = std::make_shared<EstimatorRun>();
  const auto& module_s = session->signals.module.t_s;
  measured->history.estimated_from.clear();
  measured->history.set_measured(session->signals.loadcell,
                                 module_s.empty() ? 0.0 : module_s.front());
  view_->set_cursors({});
  const auto before = std::exchange(session_, std::move(session));  // the view still shows it
  show_runs(std::move(measured), nullptr);
  view_->show_all();
  runs_->set_enabled(true);
  shell().caption_changed();
  run_first();
}

void ReplayPage::run_first() {
  work_->start(
      QStringLiteral("Estimating"),
      [this, session = session_](const WorkBar::Progress&) -> std::function<void()> {
        auto run = std::make_shared<const EstimatorRun>(run_estimator(*session, {}));
        return [=, this] {
          show_runs(run, nullptr);
          view_->say(QString::fromStdString(run->remark) +
                     QStringLiteral("What does the simulation leave out? Ctrl+3 goes to Diagnose. "
                                    "R runs the estimator with other settings."));
        };
      },
      [this](const QString& why) { view_->say(why); });
}

void ReplayPage::run_again() {
  if (!session_) return view_->say(QStringLiteral("Open a recording first, with Ctrl+O."));
  const RunSettings settings = runs_->settings();
  work_->start(
      QStringLiteral("Estimating: %1").arg(QString::fromStdString(words_for(settings))),
      [this, settings, session = session_](const WorkBar::Progress&) -> std::function<void()> {
        auto made = std::make_shared<EstimatorRun>(run_estimator(*session, settings));
        made->history.estimated_from = words_for(settings);
        return [this, made] {
          show_runs(first_, made);
          view_->say(QString::fromStdString(made->remark));
        };
      },
      [this](const QString& why) { view_->say(why); });
}

/// The view lets go of the old columns before they go.
void ReplayPage::show_runs(Run first, Run second) {
  if (!first) return;
  view_->show_histories(&first->history, second ? &second->history : nullptr);
  first_ = std::move(first);
  second_ = std::move(second);
  view_->show_numbers(session_->recording, session_->clock);
  view_->set_cursors(view_->cursors());
  runs_->show_runs(first_->history.t_s.empty() ? nullptr : first_.get(), second_.get());
}

void ReplayPage::use_model(const std::filesystem::path& file) {
  runs_->use_model(file);
  view_->say(QStringLiteral("R runs the estimator with the model %1 over the recording.")
                 .arg(QString::fromStdString(file.filename().string())));
}

/// Where the pointer is, else in the middle.
void ReplayPage::set_cursor(bool second) {
  const Range shown = view_->range();
  double at_s = 0.5 * (shown.low + shown.high);
  for (TimePlot* plot : view_->plots())
    if (plot->canvas().underMouse())
      at_s = plot->time_at(plot->canvas().mapFromGlobal(QCursor::pos()).x());
  Cursors cursors = view_->cursors();
  (second ? cursors.b_s : cursors.a_s) = at_s;
  view_->set_cursors(cursors);
}

void ReplayPage::step_cursor(bool second, int pixels) {
  Cursors cursors = view_->cursors();
  auto& cursor = second ? cursors.b_s : cursors.a_s;
  if (!cursor) return set_cursor(second);
  const Range shown = view_->range();
  *cursor += pixels * (shown.high - shown.low) / view_->plots().front()->canvas().width();
  view_->set_cursors(cursors);
}

void ReplayPage::wait() {
  work_->wait();
}

QString ReplayPage::caption() const {
  return session_ ? QString::fromStdString(session_->recording.name) : QString();
}

QString ReplayPage::message() const {
  return view_->said();
}

void ReplayPage::set_theme(const Theme& theme) {
  view_->set_theme(theme);
}

}  // namespace searig::app::desktop
