#include "app/desktop/replay/history_view.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/desktop/plot/time_plot.h"
#include "app/desktop/readouts.h"
#include "app/desktop/wording.h"

namespace searig::app::desktop {
namespace {

enum Place : std::size_t { stiffness, error, weight, clocks, streams };

}  // namespace

HistoryView::HistoryView(QWidget* parent)
    : QWidget(parent),
      readouts_(new Readouts(this)),
      hint_(new QLabel(this)),
      status_(new QLabel(this)) {
  readouts_->add(QStringLiteral("spring stiffness"), true);
  readouts_->add(QStringLiteral("torque error"));
  readouts_->add(QStringLiteral("trust in motor current"));
  readouts_->add(QStringLiteral("clocks"));
  readouts_->add(QStringLiteral("rows"));
  hint_->setContentsMargins(14, 0, 14, 8);
  hint_->setWordWrap(true);
  hint_->setObjectName(QStringLiteral("hint"));
  status_->setContentsMargins(14, 4, 14, 6);  // in line with the numbers above
  status_->setObjectName(QStringLiteral("status"));
  make_plots();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(1);
  layout->addWidget(readouts_);
  layout->addWidget(hint_);
  layout->addWidget(torque_, 5);
  layout->addWidget(weight_, 3);
  layout->addWidget(stiffness_, 3);
  layout->addWidget(status_);
  show_range(range_);
}

void HistoryView::make_plots() {
  torque_ = new TimePlot(QStringLiteral("Torque"), QStringLiteral("torque (N·m)"), this);
  torque_->setObjectName(QStringLiteral("torque"));
  torque_->add_curve(QStringLiteral("measured by the load cell"), Hue::ink);
  torque_->add_curve(QStringLiteral("estimated from the spring"), Hue::blue);
  weight_ = new TimePlot(QStringLiteral("Trust in the motor current"),
                         QStringLiteral("weight (0 to 1)"), this);
  weight_->setObjectName(QStringLiteral("weight"));
  weight_->add_curve(QStringLiteral("weight"), Hue::purple);
  weight_->fix_y({-0.05, 1.05});
  stiffness_ =
      new TimePlot(QStringLiteral("Spring stiffness"), QStringLiteral("k (N·m/rad)"), this);
  stiffness_->setObjectName(QStringLiteral("stiffness"));
  stiffness_->add_curve(QStringLiteral("online estimate"), Hue::green);
}

void HistoryView::show_history(const History* history, bool online) {
  history_ = history;
  torque_->set_data(0, &history->measured_t_s, &history->measured_nm);
  torque_->set_data(1, &history->t_s, &history->estimated_nm);
  weight_->set_data(0, &history->t_s, &history->weight);
  stiffness_->set_data(0, &history->t_s, &history->stiffness_nm_per_rad);
  torque_->rename_curve(1, QString::fromStdString(history->estimated_from));
  weight_->setVisible(online);
  stiffness_->setVisible(online);
}

void HistoryView::show_numbers(const acquisition::Recording& recording,
                               const acquisition::ClockMap& clock, bool live) {
  readouts_->set(stiffness, stiffness_words(*history_), spread_words(*history_));
  readouts_->set(error, error_words(*history_, live),
                 live ? QStringLiteral("last 20 s") : QString());
  readouts_->set(weight, weight_words(*history_));
  readouts_->set(clocks, clock_words(recording, clock));
  readouts_->set(streams, loss_words(recording));
  status_->setText(status_words(recording, clock));
  status_->setToolTip(QString::fromStdString(clock.why));
}

void HistoryView::say(const QString& words) {
  hint_->setText(words);
  hint_->setVisible(!words.isEmpty());
}

QString HistoryView::said() const {
  return hint_->text();
}

void HistoryView::show_range(Range time_s) {
  range_ = time_s;
  // From zero to twice the latest value: a first guess ten times too high would flatten the rest.
  if (history_ && !history_->stiffness_nm_per_rad.empty())
    stiffness_->fix_y({0.0, 2.0 * std::max(1e-6, history_->stiffness_nm_per_rad.back())});
  for (auto* plot : {torque_, weight_, stiffness_}) plot->show_range(time_s);
}

void HistoryView::zoom(double factor) {
  const double span = std::clamp((range_.high - range_.low) * factor, 0.05, 36000.0);
  const double centre = 0.5 * (range_.low + range_.high);
  show_range({centre - 0.5 * span, centre + 0.5 * span});
}

void HistoryView::move(double share) {
  const double by = share * (range_.high - range_.low);
  show_range({range_.low + by, range_.high + by});
}

void HistoryView::show_all() {
  if (!history_) return;
  const auto end_of = [](const std::vector<double>& t_s) { return t_s.empty() ? 0.0 : t_s.back(); };
  const double end = std::max(end_of(history_->t_s), end_of(history_->measured_t_s));
  show_range({0.0, std::max(1.0, end)});
}

void HistoryView::set_theme(const Theme& theme) {
  for (auto* plot : {torque_, weight_, stiffness_}) plot->set_theme(theme);
  show_range(range_);
}

}  // namespace searig::app::desktop
