// Menus and keys of the main window, and what they do to the view.
#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QMenuBar>
#include <QStyle>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/desktop/main_window.h"
#include "app/desktop/time_plot.h"

namespace searig::app::desktop {

void MainWindow::make_actions() {
  const auto add = [this](QMenu* menu, const char* words, const QKeySequence& keys, auto action) {
    QAction* made = menu->addAction(QString::fromUtf8(words));
    made->setShortcut(keys);
    connect(made, &QAction::triggered, this, action);
    return made;
  };
  QMenu* file = menuBar()->addMenu(QStringLiteral("&File"));
  add(file, "&Open recording…", QKeySequence::Open, [this] { choose_recording(); });
  file->addSeparator();
  add(file, "&Quit", QKeySequence::Quit, [this] { close(); });

  QMenu* rig = menuBar()->addMenu(QStringLiteral("&Rig"));
  add(rig, "&Simulated", QKeySequence(int(Qt::CTRL) | Qt::Key_R), [this] { start_simulated(); });

  QMenu* view = menuBar()->addMenu(QStringLiteral("&View"));
  pause_action_ = add(view, "&Pause (data go on)", QKeySequence(Qt::Key_Space),
                      [this] { pause(pause_action_->isChecked()); });
  pause_action_->setCheckable(true);
  pause_action_->setEnabled(false);
  view->addSeparator();
  add(view, "Zoom &in", QKeySequence(Qt::Key_Plus), [this] { zoom(0.5); });
  add(view, "Zoom &out", QKeySequence(Qt::Key_Minus), [this] { zoom(2.0); });
  add(view, "&Earlier", QKeySequence(Qt::Key_Left), [this] { move_view(-0.25); });
  add(view, "&Later", QKeySequence(Qt::Key_Right), [this] { move_view(0.25); });
  add(view, "&Whole recording", QKeySequence(Qt::Key_Home), [this] { show_all(); });
  view->addSeparator();
  QAction* dark = add(view, "&Dark", QKeySequence(int(Qt::CTRL) | Qt::Key_D), [] {});
  dark->setCheckable(true);
  dark->setChecked(theme_.dark());
  connect(dark, &QAction::toggled, this, [this](bool on) {
    const Theme theme(on);
    theme.apply(*qApp);
    set_theme(theme);
  });
}

void MainWindow::choose_recording() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, QStringLiteral("Open a recording folder"));
  if (!folder.isEmpty()) open(folder.toStdString());
}

void MainWindow::pause(bool on) {
  if (!on) span_s_ = std::clamp(view_.high - view_.low, 1.0, 600.0);
}

void MainWindow::zoom(double factor) {
  if (!content_) return;
  const double span = std::clamp((view_.high - view_.low) * factor, 0.05, 36000.0);
  if (content_->live() && !pause_action_->isChecked()) {
    span_s_ = std::clamp(span, 1.0, 600.0);
    return;
  }
  const double centre = 0.5 * (view_.low + view_.high);
  view_ = {centre - 0.5 * span, centre + 0.5 * span};
  refresh();
}

void MainWindow::move_view(double share) {
  if (!content_ || (content_->live() && !pause_action_->isChecked())) return;
  const double by = share * (view_.high - view_.low);
  view_ = {view_.low + by, view_.high + by};
  refresh();
}

void MainWindow::show_all() {
  if (!content_) return;
  const auto& history = content_->history();
  const double end = std::max(history.t_s.empty() ? 0.0 : history.t_s.back(),
                              history.measured_t_s.empty() ? 0.0 : history.measured_t_s.back());
  view_ = {0.0, std::max(1.0, end)};
  refresh();
}

std::string MainWindow::describe_layout() const {
  nlohmann::json plots;
  const auto add = [&](const char* name, const TimePlot& plot) {
    const QPoint corner = plot.canvas().mapTo(this, QPoint(0, 0));
    const Range x = plot.x_range(), y = plot.y_range();
    plots[name] = {{"left", corner.x()},
                   {"top", corner.y()},
                   {"width", plot.canvas().width()},
                   {"height", plot.canvas().height()},
                   {"x", {x.low, x.high}},
                   {"y", {y.low, y.high}}};
  };
  add("torque", *torque_plot_);
  add("weight", *weight_plot_);
  add("stiffness", *stiffness_plot_);
  return nlohmann::json{{"plots", plots}}.dump(1);
}

}  // namespace searig::app::desktop
