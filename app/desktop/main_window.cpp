#include "app/desktop/main_window.h"

#include <QAction>
#include <QLabel>
#include <QStatusBar>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/desktop/readouts.h"
#include "app/desktop/time_plot.h"
#include "app/desktop/wording.h"

namespace searig::app::desktop {
namespace {

constexpr int frame_ms = 33;  // 30 frames per second
enum Place : std::size_t { stiffness, error, weight, clocks, streams };

}  // namespace

MainWindow::MainWindow(const Theme& theme) : theme_(theme) {
  setWindowTitle(QStringLiteral("searig"));
  resize(1280, 800);
  readouts_ = new Readouts(this);
  readouts_->add(QStringLiteral("spring stiffness"), true);
  readouts_->add(QStringLiteral("torque error"));
  readouts_->add(QStringLiteral("trust in motor current"));
  readouts_->add(QStringLiteral("clocks"));
  readouts_->add(QStringLiteral("rows"));
  hint_ = new QLabel(this);
  hint_->setContentsMargins(14, 0, 14, 8);
  hint_->setWordWrap(true);
  make_plots();

  auto* middle = new QWidget(this);
  auto* layout = new QVBoxLayout(middle);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(1);
  layout->addWidget(readouts_);
  layout->addWidget(hint_);
  layout->addWidget(torque_plot_, 5);
  layout->addWidget(weight_plot_, 3);
  layout->addWidget(stiffness_plot_, 3);
  setCentralWidget(middle);
  status_ = new QLabel(this);
  status_->setContentsMargins(12, 0, 0, 0);  // in line with the numbers above
  statusBar()->addWidget(status_, 1);
  statusBar()->setSizeGripEnabled(false);

  make_actions();
  set_theme(theme);
  for (auto* plot : {torque_plot_, weight_plot_, stiffness_plot_}) plot->show_range(view_);
  timer_.setInterval(frame_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  hint_->setText(
      QStringLiteral("Start the simulated rig with Ctrl+R, or open a recording with Ctrl+O."));
}

MainWindow::~MainWindow() = default;

void MainWindow::make_plots() {
  torque_plot_ = new TimePlot(QStringLiteral("Torque"), QStringLiteral("torque (N·m)"), this);
  torque_plot_->add_curve(QStringLiteral("measured by the load cell"), Hue::ink);
  torque_plot_->add_curve(QStringLiteral("estimated from the spring"), Hue::blue);
  weight_plot_ = new TimePlot(QStringLiteral("Trust in the motor current"),
                              QStringLiteral("weight (0 to 1)"), this);
  weight_plot_->add_curve(QStringLiteral("weight"), Hue::purple);
  weight_plot_->fix_y({-0.05, 1.05});
  stiffness_plot_ =
      new TimePlot(QStringLiteral("Spring stiffness"), QStringLiteral("k (N·m/rad)"), this);
  stiffness_plot_->add_curve(QStringLiteral("online estimate"), Hue::green);
}

void MainWindow::start_simulated(double ahead_s) {
  show_content(simulated_rig());
  ahead_s_ = ahead_s;
  // As many steps as a live view would have taken, so that both show the same.
  for (double t = 0.0; t < ahead_s; t += 1e-3 * frame_ms) content_->run_until(t);
  since_start_.start();
  timer_.start();
  tick();
}

bool MainWindow::open(const std::filesystem::path& folder) {
  try {
    show_content(open_recording(folder));
  } catch (const std::exception& error) {
    hint_->setText(QString::fromUtf8(error.what()));
    hint_->show();
    return false;
  }
  show_all();
  return true;
}

QString MainWindow::message() const {
  return hint_->text();
}

void MainWindow::show_content(std::unique_ptr<Content> content) {
  timer_.stop();
  const History& history = content->history();
  torque_plot_->set_data(0, &history.measured_t_s, &history.measured_nm);
  torque_plot_->set_data(1, &history.t_s, &history.estimated_nm);
  weight_plot_->set_data(0, &history.t_s, &history.weight);
  stiffness_plot_->set_data(0, &history.t_s, &history.stiffness_nm_per_rad);
  torque_plot_->rename_curve(1, QString::fromStdString(history.estimated_from));
  const bool online = content->live() || !history.stiffness_nm_per_rad.empty();
  weight_plot_->setVisible(online);
  stiffness_plot_->setVisible(online);
  content_ = std::move(content);  // the plots have let go of the old one's columns
  pause_action_->setEnabled(content_->live());
  pause_action_->setChecked(false);
  hint_->setText(content_->remark());
  hint_->setVisible(!content_->remark().isEmpty());
  setWindowTitle(content_->name() + QStringLiteral(" – searig"));
}

void MainWindow::tick() {
  content_->run_until(ahead_s_ + 1e-3 * static_cast<double>(since_start_.elapsed()));
  if (pause_action_->isChecked()) return refresh_numbers();
  const auto& t_s = content_->history().t_s;
  shown_until_s_ = t_s.empty() ? 0.0 : t_s.back();
  view_ = {shown_until_s_ - span_s_, shown_until_s_};
  if (shown_until_s_ < span_s_) view_ = {0.0, span_s_};
  refresh();
}

void MainWindow::refresh() {
  if (!content_) return;
  const auto& k = content_->history().stiffness_nm_per_rad;
  // From zero to twice the latest value: a first guess ten times too high would flatten the rest.
  if (!k.empty()) stiffness_plot_->fix_y({0.0, 2.0 * std::max(1e-6, k.back())});
  for (auto* plot : {torque_plot_, weight_plot_, stiffness_plot_}) plot->show_range(view_);
  refresh_numbers();
}

void MainWindow::refresh_numbers() {
  const auto& history = content_->history();
  const auto& recording = content_->recording();
  readouts_->set(stiffness, stiffness_words(history), spread_words(history));
  readouts_->set(error, error_words(history, content_->live()),
                 content_->live() ? QStringLiteral("last 20 s") : QString());
  readouts_->set(weight, weight_words(history));
  readouts_->set(clocks, clock_words(recording, content_->clock()));
  readouts_->set(streams, loss_words(recording));
  status_->setText(status_words(recording, content_->clock()));
  status_->setToolTip(QString::fromStdString(content_->clock().why));
}

void MainWindow::set_theme(const Theme& theme) {
  theme_ = theme;
  for (auto* plot : {torque_plot_, weight_plot_, stiffness_plot_}) plot->set_theme(theme);
  refresh();
}

}  // namespace searig::app::desktop
