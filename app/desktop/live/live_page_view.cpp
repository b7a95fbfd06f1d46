// How the live page is laid out, and what its numbers and words say.
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/desktop/live/calibration_panel.h"
#include "app/desktop/live/connect_panel.h"
#include "app/desktop/live/live_page.h"
#include "app/desktop/live/live_plots.h"
#include "app/desktop/live/record_panel.h"
#include "app/desktop/live/sync_panel.h"
#include "app/desktop/readouts.h"
#include "app/report/axis.h"

namespace searig::app::desktop {
namespace {

constexpr int side_width = 292;
constexpr int most_events = 200, notice_ms = 8000;
enum Place : std::size_t { stiffness, error };

QString said(double value, int decimals) {
  return QString::fromStdString(number(value, decimals));
}

int decimals_for(double value) {
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(value) + 1e-12))), 0, 4);
}

/// Read from two metres.
void paint_pill(QLabel& label, const Theme& theme, const QColor& colour) {
  const QString style = QStringLiteral(
                            "QLabel { background: %1; color: %2; font-size: 20pt; "
                            "font-weight: bold; padding: 6px 14px; }")
                            .arg(colour.name(), theme.colour(ground).name());
  if (label.styleSheet() != style) label.setStyleSheet(style);  // which costs
}

}  // namespace

void LivePage::make_layout() {
  rec_ = new QLabel(QStringLiteral("● REC"), this);
  rec_->setObjectName(QStringLiteral("rec"));
  verdict_ = new QLabel(this);
  verdict_->setObjectName(QStringLiteral("verdict"));
  readouts_ = new Readouts(this);
  readouts_->add(QStringLiteral("spring stiffness"), true);
  readouts_->add(QStringLiteral("torque error, last 20 s"), true);
  hint_ = new QLabel(this);
  hint_->setObjectName(QStringLiteral("hint"));
  hint_->setWordWrap(true);
  hint_->setContentsMargins(14, 0, 14, 6);
  plots_ = new LivePlots(this);
  calibration_ = new CalibrationPanel(this);
  views_ = new QStackedWidget(this);
  views_->addWidget(plots_);
  views_->addWidget(calibration_);
  choice_ = new ConnectPanel(this);
  record_ = new RecordPanel(this);
  sync_ = new SyncPanel(this);
  events_ = new QListWidget(this);  // the newest on top
  events_->setObjectName(QStringLiteral("events"));
  events_->setWordWrap(true);
  events_->setFocusPolicy(Qt::NoFocus);
  events_->setSelectionMode(QAbstractItemView::NoSelection);
  events_->setMinimumHeight(40);

  auto* side = new QWidget(this);
  side->setFixedWidth(side_width);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(8, 4, 8, 4);
  column->setSpacing(4);
  for (QWidget* panel : std::initializer_list<QWidget*>{choice_, record_, sync_})
    column->addWidget(panel);
  column->addWidget(events_, 1);
  auto* top = new QHBoxLayout;
  top->setSpacing(0);
  top->addWidget(rec_);
  top->addWidget(verdict_);
  top->addWidget(readouts_, 1);
  auto* main = new QVBoxLayout;
  main->setSpacing(0);
  main->addLayout(top);
  main->addWidget(hint_);
  main->addWidget(views_, 1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(main, 1);
  layout->addWidget(side);
  calibration_->leave = [this] {
    views_->setCurrentWidget(plots_);
    setFocus();
  };
  calibration_->use = [this](const std::filesystem::path& file) {
    choice_->set_calibration(file.string());
    close_rig();
    again_ = true;  // with it
  };
}

void LivePage::show_numbers() {
  const RecordingStatus recording = rig_ ? rig_->recording() : RecordingStatus{};
  LiveVerdict verdict{Trust::unknown, "NOT CONNECTED", ""};
  if (rig_ || shown_) verdict = verdict_of(news_, has_model_);
  verdict_->setText(QString::fromStdString(verdict.words));
  verdict_->setToolTip(QString::fromStdString(verdict.why));
  paint_pill(*verdict_, theme_,
             verdict.trust == Trust::yes  ? theme_.colour(Hue::green)
             : verdict.trust == Trust::no ? theme_.colour(Hue::vermilion)
                                          : theme_.colour(faint));
  rec_->setVisible(recording.running);
  paint_pill(*rec_, theme_, theme_.colour(Hue::purple));
  verdict_why_ = verdict.trust == Trust::yes ? QString() : QString::fromStdString(verdict.why);
  show_hint();

  const LiveColumns& c = plots_->columns();
  const double k = c.k_nm_per_rad.empty() ? NAN : c.k_nm_per_rad.back();
  const double low = c.k_nm_per_rad.empty() ? NAN : c.k_low_nm_per_rad.back();
  const double high = c.k_nm_per_rad.empty() ? NAN : c.k_high_nm_per_rad.back();
  const double error_percent = c.error_percent(plots_->now_s() - 20.0);
  const QString none = QStringLiteral("–");
  readouts_->set(
      stiffness, std::isnan(k) ? none : said(k, decimals_for(k)) + QStringLiteral(" N·m/rad"),
      std::isnan(low) ? QString()
                      : QStringLiteral("95 % %1 to %2")
                            .arg(said(low, decimals_for(k)), said(high, decimals_for(k))));
  readouts_->set(error, std::isnan(error_percent) ? none : said(error_percent, 1) + " %");
  sync_->show(news_);
  record_->show_status(recording, connected());
}

void LivePage::note_events(const LiveNews& news) {
  for (const auto& event : news.events) {
    if (event.kind == "identity" || event.kind == "wrap") continue;
    events_->insertItem(0,
                        QStringLiteral("%1 s   %2")
                            .arg(said(news.time_of(event), 1), QString::fromStdString(event.text)));
  }
  while (events_->count() > most_events) delete events_->takeItem(events_->count() - 1);
}

void LivePage::say(const QString& words) {
  notice_ = words;
  since_notice_.start();
  show_hint();
}

/// What there is to do now, where nothing is wrong.
QString LivePage::next_step() const {
  if (!rig_) return {};
  const RecordingStatus recording = rig_->recording();
  if (views_->currentWidget() == calibration_) return {};  // which has its own steps
  if (plots_->leading())
    return recording.running
               ? QStringLiteral(
                     "Recording. Keep on the target where \"now\" stands; T takes it away.")
               : QStringLiteral(
                     "Keep on the target where \"now\" stands. Nothing is recorded: R records.");
  if (recording.running)
    return QStringLiteral("Recording. M marks what you see; R stops, a minute or two are enough.");
  if (!recording.file.empty() && recording.failure.empty())
    return QStringLiteral("Recorded. O opens it in Replay; R records another one.");
  return QStringLiteral("Connected. R records; C calibrates the load cell with known weights.");
}

/// What was said last, for a while; then what there is to say of the data; then what to do.
void LivePage::show_hint() {
  const bool holds = !rig_ || since_notice_.elapsed() < notice_ms;
  QString words = holds && !notice_.isEmpty() ? notice_
                  : plots_->leading()         ? next_step()
                                              : verdict_why_;
  if (words.isEmpty()) words = next_step();
  if (hint_->text() == words) return;
  hint_->setText(words);
  hint_->setVisible(!words.isEmpty());
}

QString LivePage::message() const {
  return hint_->text();
}

}  // namespace searig::app::desktop
