// The first window: the paper's two live plots, the stiffness, and whether to trust the data.
#pragma once

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <filesystem>
#include <memory>

#include "app/desktop/content.h"
#include "app/desktop/theme.h"
#include "app/report/plot.h"

class QAction;
class QLabel;

namespace searig::app::desktop {

class Readouts;
class TimePlot;

class MainWindow : public QMainWindow {
 public:
  explicit MainWindow(const Theme& theme);
  ~MainWindow() override;

  /// Starts the simulated rig; `ahead_s` of it have passed already.
  void start_simulated(double ahead_s = 0.0);
  /// False where it could not be opened; the window then says why, without a dialog.
  bool open(const std::filesystem::path& folder);
  QString message() const;

  /// Where things are on the window, for tests that look at pixels: JSON.
  std::string describe_layout() const;

 private:
  void make_actions();
  void make_plots();
  void show_content(std::unique_ptr<Content> content);
  void choose_recording();
  void tick();
  void pause(bool on);
  void refresh();
  void refresh_numbers();
  void zoom(double factor);
  void move_view(double share);
  void show_all();
  void set_theme(const Theme& theme);
  Range time_range() const;

  Theme theme_;
  std::unique_ptr<Content> content_;
  Readouts* readouts_ = nullptr;
  TimePlot* torque_plot_ = nullptr;
  TimePlot* weight_plot_ = nullptr;
  TimePlot* stiffness_plot_ = nullptr;
  QLabel* hint_ = nullptr;    // what to do next, or what went wrong
  QLabel* status_ = nullptr;  // of the clocks and streams
  QAction* pause_action_ = nullptr;
  QTimer timer_;
  QElapsedTimer since_start_;
  double ahead_s_ = 0.0;
  double shown_until_s_ = 0.0;  // while paused the data go on and the view stays
  double span_s_ = 20.0;        // of the live view
  Range view_{0.0, 20.0};       // of a recording or a paused view
};

}  // namespace searig::app::desktop
