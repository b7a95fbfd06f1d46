#include "app/desktop/diagnose/diagnose_page.h"

#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <utility>

#include "app/desktop/diagnose/finding_text.h"
#include "app/desktop/diagnose/guided_motion.h"
#include "app/desktop/diagnose/map_view.h"
#include "app/desktop/plot/time_plot.h"
#include "app/desktop/work_bar.h"
#include "app/report/diagnosis_plots.h"
#include "app/report/diagnosis_sentences.h"

namespace searig::app::desktop {
namespace {

constexpr std::size_t most_curves = 2;  // before and after

QString name_of(const std::filesystem::path& file) {
  return QString::fromStdString(file.filename().string());
}

/// "before: same physics, best numbers" has no room above a plot that shares its row.
QString short_name(const std::string& name) {
  return QString::fromStdString(name.substr(0, name.find(':')));
}

/// Seconds since the first telemetry, as everywhere in the window.
void shift(Plot& plot, double by_s) {
  for (Series& series : plot.series)
    for (double& t : series.x) t += by_s;
  for (Interval& interval : plot.shaded)
    interval = {interval.from + by_s, interval.to + by_s, interval.hue};
}

}  // namespace

void DiagnosePage::say(const QString& words) {
  hint_->setText(words);
  hint_->setVisible(!words.isEmpty());
}

void DiagnosePage::choose(std::shared_ptr<const Session> session) {
  work_->cancel();
  session_ = std::move(session);
  model_file_.reset();
  show_result(nullptr);
  say(QStringLiteral("Press D, or the button, to hold %1 against the model.").arg(caption()));
}

void DiagnosePage::use_model(const std::filesystem::path& file) {
  model_file_ = file;
  follow_state();
}

void DiagnosePage::diagnose() {
  if (!session_) return say(QStringLiteral("Open a recording first, with Ctrl+O."));
  say({});
  left_->setCurrentIndex(int(Left::differences));
  work_->start(
      QStringLiteral("Beginning"),
      [this, session = session_,
       file = model_file_](const WorkBar::Progress& progress) -> std::function<void()> {
        const auto model = find_model(session->recording, file);
        auto found = std::make_shared<const Examined>(examine({session.get()}, model, progress));
        return [this, found] { show_result(found); };
      },
      [this](const QString& why) { say(why); });
  follow_state();
}

void DiagnosePage::show_result(std::shared_ptr<const Examined> examined) {
  examined_ = std::move(examined);
  verdict_->setText(examined_ ? QString::fromStdString(headline(examined_->diagnosis)) : QString());
  verdict_->setVisible(examined_ != nullptr);
  finding_->setText(examined_ ? finding_text(*examined_) : QString());
  map_->show_map(examined_);
  left_->setCurrentIndex(int(Left::differences));
  show_residual();
  shell().mark_mismatch(residual_.shaded);
  follow_state();
  if (!examined_) return;
  using estimator::Verdict;
  const Verdict verdict = examined_->diagnosis.verdict;
  say(verdict == Verdict::missing_physics || verdict == Verdict::recalibrate
          ? QStringLiteral("A accepts this: the extended model is written beside the recording and "
                           "used from then on. N shows the next experiment.")
      : verdict == Verdict::consistent
          ? QStringLiteral("The model and the recording agree. Ctrl+O opens another one.")
          : QStringLiteral("P writes what is known as a report; N shows the next experiment "
                           "where one is known."));
}

void DiagnosePage::show_residual() {
  Plot plot;
  if (examined_) {
    const Against path = main_path(*examined_);
    plot = residual_over_time(*examined_, path, intervals_to_shade(*examined_));
    shift(plot, -examined_->signals.module.t_s.front());
  }
  // What is shown until here goes with the old plot.
  residual_ = std::move(plot);
  residual_.series.resize(most_curves);
  const Hue hues_of[] = {Hue::vermilion, Hue::blue};
  for (std::size_t i = 0; i < most_curves; ++i) {
    // Where there is no before, what is left is the second curve, in its colour.
    if (i == 0 && residual_.series[0].hue != hues_of[0])
      std::swap(residual_.series[0], residual_.series[1]);
    const Series& series = residual_.series[i];
    residual_plot_->set_data(i, &series.x, &series.y);
    residual_plot_->rename_curve(i, short_name(series.name));
  }
  residual_plot_->set_shaded(residual_.shaded, QString::fromStdString(residual_.shaded_name));
  residual_plot_->fix_y(residual_.y_range.value_or(Range{-1.0, 1.0}));
  const auto& t_s = residual_.series[1].x;
  show_range({0.0, t_s.empty() ? 20.0 : t_s.back()});
}

void DiagnosePage::show_range(Range time_s) {
  range_ = time_s;
  residual_plot_->show_range(time_s);
}

/// The buttons and the words beside them say what can be done now.
void DiagnosePage::follow_state() {
  using estimator::Verdict;
  const bool busy = work_->busy();
  const auto verdict = examined_ ? std::optional(examined_->diagnosis.verdict) : std::nullopt;
  diagnose_->setEnabled(session_ && !busy);
  accept_->setEnabled(!busy &&
                      (verdict == Verdict::missing_physics || verdict == Verdict::recalibrate));
  next_->setEnabled(finding_with_motion() != nullptr);
  report_->setEnabled(examined_ && !busy);
  model_->setText(!session_     ? QString()
                  : model_file_ ? QStringLiteral("Held against %1").arg(name_of(*model_file_))
                                : QStringLiteral("Held against the recording's own model, or the "
                                                 "paper's where it has none"));
}

void DiagnosePage::wait() {
  work_->wait();
}

QString DiagnosePage::caption() const {
  return session_ ? QString::fromStdString(session_->recording.name) : QString();
}

QString DiagnosePage::message() const {
  return hint_->text();
}

void DiagnosePage::set_theme(const Theme& theme) {
  residual_plot_->set_theme(theme);
  map_->set_theme(theme);
  guided_->set_theme(theme);
  show_residual();  // the shading in the new colours
}

}  // namespace searig::app::desktop
