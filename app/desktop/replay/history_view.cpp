#include "app/desktop/replay/history_view.h"

#include <QLabel>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/desktop/plot/time_mouse.h"
#include "app/desktop/plot/time_plot.h"
#include "app/desktop/readouts.h"
#include "app/desktop/wording.h"

namespace searig::app::desktop {
namespace {

enum Place : std::size_t { stiffness, error, weight, clocks, streams };

constexpr double scrub_steps = 1e6;  // of the scroll bar, which counts in whole numbers
constexpr double shortest_s = 0.05, longest_s = 36000.0;

}  // namespace

HistoryView::HistoryView(QWidget* parent)
    : QWidget(parent),
      readouts_(new Readouts(this)),
      hint_(new QLabel(this)),
      status_(new QLabel(this)),
      scrub_(new QScrollBar(Qt::Horizontal, this)) {
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
  status_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  scrub_->setObjectName(QStringLiteral("scrub"));
  scrub_->setFocusPolicy(Qt::NoFocus);
  connect(scrub_, &QScrollBar::valueChanged, this, [this](int value) { scroll_to(value); });
  make_plots();
  watch_mouse();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(1);
  layout->addWidget(readouts_);
  layout->addWidget(hint_);
  auto* column = new QVBoxLayout;
  column->setSpacing(1);
  const int shares[] = {10, 6, 5, 9};
  for (std::size_t i = 0; i < plots().size(); ++i) column->addWidget(plots()[i], shares[i]);
  column->addWidget(scrub_);
  row_ = new QHBoxLayout;
  row_->setSpacing(0);
  row_->addLayout(column, 1);
  layout->addLayout(row_, 1);
  layout->addWidget(status_);
  show_range(range_);
}

void HistoryView::watch_mouse() {
  auto* mouse =
      new TimeMouse(this, {.zoom = [this](double factor, double at_s) { zoom_at(factor, at_s); },
                           .move = [this](double share) { move(share); },
                           .show = [this](Range time_s) { zoom_to(time_s); },
                           .click =
                               [this](double at_s, bool second) {
                                 Cursors cursors = cursors_;
                                 (second ? cursors.b_s : cursors.a_s) = at_s;
                                 set_cursors(cursors);
                               },
                           .show_all = [this] { show_all(); }});
  for (TimePlot* plot : plots()) mouse->watch(*plot);
}

void HistoryView::show_numbers(const acquisition::Recording& recording,
                               const acquisition::ClockMap& clock) {
  readouts_->set(stiffness, stiffness_words(*first_), spread_words(*first_));
  readouts_->set(error, error_words(*first_, false));
  readouts_->set(weight, weight_words(*first_));
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

double HistoryView::end_s() const {
  if (!first_) return 1.0;
  const auto end_of = [](const std::vector<double>& t_s) { return t_s.empty() ? 0.0 : t_s.back(); };
  return std::max({1.0, end_of(first_->t_s), end_of(first_->measured_t_s)});
}

void HistoryView::show_range(Range time_s) {
  range_ = time_s;
  double latest = 0.0;
  for (const History* history : {first_, second_})
    if (history && !history->stiffness_nm_per_rad.empty())
      latest = std::max(latest, history->stiffness_nm_per_rad.back());
  stiffness_->follow_y_about(latest);
  for (TimePlot* plot : plots()) plot->show_range(time_s);
  place_scroll_bar();
}

void HistoryView::zoom(double factor) {
  zoom_at(factor, 0.5 * (range_.low + range_.high));
}

/// What is under the pointer stays there.
void HistoryView::zoom_at(double factor, double at_s) {
  const double now = range_.high - range_.low;
  const double span = std::clamp(now * factor, shortest_s, longest_s);
  const double low = at_s - (at_s - range_.low) * span / now;
  show_range({low, low + span});
}

void HistoryView::zoom_to(Range time_s) {
  if (time_s.high - time_s.low < shortest_s) return;
  before_.push_back(range_);
  show_range(time_s);
}

void HistoryView::back() {
  if (before_.empty()) return show_all();
  show_range(before_.back());
  before_.pop_back();
}

void HistoryView::move(double share) {
  const double by = share * (range_.high - range_.low);
  show_range({range_.low + by, range_.high + by});
}

void HistoryView::show_all() {
  if (!first_) return;
  before_.clear();
  show_range({0.0, end_s()});
}

void HistoryView::place_scroll_bar() {
  const QSignalBlocker quiet(scrub_);
  const double share = std::min(1.0, (range_.high - range_.low) / end_s());
  scrub_->setPageStep(std::max(1, int(scrub_steps * share)));
  scrub_->setSingleStep(std::max(1, int(0.1 * scrub_steps * share)));
  scrub_->setMaximum(int(scrub_steps) - scrub_->pageStep());
  scrub_->setValue(int(scrub_steps * range_.low / end_s()));
  scrub_->setVisible(first_ != nullptr);
}

void HistoryView::scroll_to(int value) {
  const double low = value / scrub_steps * end_s();
  show_range({low, low + range_.high - range_.low});
}

void HistoryView::set_cursors(const Cursors& cursors) {
  cursors_ = cursors;
  std::vector<Mark> marks;
  if (cursors.a_s) marks.push_back({*cursors.a_s, "A", Hue::ink});
  if (cursors.b_s) marks.push_back({*cursors.b_s, "B", Hue::orange});
  std::vector<Mark> lines = marks;  // the letters stand in the uppermost plot alone
  for (Mark& line : lines) line.text.clear();
  for (TimePlot* plot : plots()) plot->set_marks(plot == torque_ ? marks : lines);
  show_range(range_);
  if (cursors_moved_) cursors_moved_();
}

}  // namespace searig::app::desktop
