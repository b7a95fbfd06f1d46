#include "app/desktop/replay/replay_page.h"

#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "app/desktop/plot/time_plot.h"
#include "app/desktop/replay/cursor_table.h"
#include "app/desktop/replay/history_view.h"
#include "app/desktop/replay/run_panel.h"
#include "app/desktop/work_bar.h"

namespace searig::app::desktop {
namespace {

constexpr int side_px = 300;
constexpr int between_growths_ms = 100;

const char* next_step(ReplayPage::Place place) {
  return place == ReplayPage::Place::first
             ? "What does the simulation leave out? Ctrl+3 goes to Diagnose. R runs the estimator "
               "with other settings."
             : "";
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
  runs_->on_take_away([this] { take_away(); });
  hold_keys(*runs_->first_k());
  make_actions();
  view_->set_cursors({});
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
  view_->set_cursors({});
  const auto before = std::exchange(session_, std::move(session));  // the view still shows it
  const auto measured = begun_run({});
  measured->history.estimated_from.clear();
  show_runs(measured, nullptr);
  tell_runs();
  view_->show_all();
  runs_->set_enabled(true);
  shell().caption_changed();
  start_run({}, Place::first);
}

/// Measured torque, and no estimate yet.
std::shared_ptr<EstimatorRun> ReplayPage::begun_run(const RunSettings& settings) const {
  auto run = std::make_shared<EstimatorRun>();
  run->settings = settings;
  run->history.set_measured(session_->signals.loadcell, start_of(*session_));
  return run;
}

void ReplayPage::run_again() {
  if (!session_) return view_->say(QStringLiteral("Open a recording first, with Ctrl+O."));
  start_run(runs_->settings(), Place::second);
}

/// The estimate is seen to grow from the left while it comes. Its columns grow here, on the
/// window's thread, from the pieces that the work hands over.
void ReplayPage::start_run(const RunSettings& settings, Place place) {
  const auto growing = begun_run(settings);
  const std::string doing =
      place == Place::first ? "estimating" : "estimating: " + words_for(settings);
  if (place == Place::second) growing->history.estimated_from = words_for(settings);
  growing->history.reserve(session_->signals.module.t_s.size());
  since_grown_.invalidate();
  work_->start(
      QString::fromStdString(doing),
      [=, this, session = session_](const WorkBar::Progress& progress) -> std::function<void()> {
        const double all_s = std::max(
            1e-9, session->signals.module.t_s.back() - session->signals.module.t_s.front());
        const auto watch = [&](History more) {
          const double share = more.t_s.empty() ? -1.0 : more.t_s.back() / all_s;
          if (!progress(doing, share)) throw std::runtime_error("Stopped.");
          progress.show([=, this, more = std::move(more)] {
            growing->history.append(more);
            show_growing(growing, place);
          });
        };
        auto made = std::make_shared<EstimatorRun>(run_estimator(*session, settings, watch));
        return [=, this] {
          // Its columns were all handed over, or none.
          const auto& run = made->history.t_s.empty() ? growing : made;
          if (run == growing) {
            growing->remark = made->remark;
            growing->residuals = std::move(made->residuals);
          }
          if (place == Place::second) run->history.estimated_from = words_for(settings);
          place == Place::first ? show_runs(run, nullptr) : show_runs(first_, run);
          tell_runs();
          view_->say(QString::fromStdString(run->remark) + QString::fromUtf8(next_step(place)));
        };
      },
      [this](const QString& why) { view_->say(why); });
}

/// A few times a second: drawing it more often would only keep the estimator waiting.
void ReplayPage::show_growing(Run run, Place place) {
  if (run->history.t_s.empty()) return;
  const bool begins = !since_grown_.isValid();
  if (!begins && since_grown_.elapsed() < between_growths_ms) return;
  since_grown_.start();
  if (begins)
    place == Place::first ? show_runs(std::move(run), nullptr) : show_runs(first_, std::move(run));
  else
    view_->show_range(view_->range());
}

/// The view lets go of the old columns before they go.
void ReplayPage::show_runs(Run first, Run second) {
  if (!first) return;
  view_->show_histories(&first->history, second ? &second->history : nullptr);
  first_ = std::move(first);
  second_ = std::move(second);
}

/// The numbers of runs that are whole.
void ReplayPage::tell_runs() {
  if (!first_) return;
  view_->show_numbers(session_->recording, session_->clock);
  view_->set_cursors(view_->cursors());
  view_->show_residuals(first_->residuals);
  runs_->show_runs(first_->history.t_s.empty() ? nullptr : first_.get(), second_.get());
}

void ReplayPage::take_away() {
  show_runs(first_, nullptr);
  tell_runs();
}

void ReplayPage::use_model(const std::filesystem::path& file) {
  runs_->use_model(file);
  view_->say(QStringLiteral("R runs the estimator with the model %1 over the recording.")
                 .arg(QString::fromStdString(file.filename().string())));
}

void ReplayPage::wait() {
  work_->wait();
}

bool ReplayPage::busy() const {
  return work_->busy();
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
