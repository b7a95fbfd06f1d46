// What the model leaves out of the opened recording: found, shown, accepted, and what to try next.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/desktop/page.h"
#include "app/report/plot.h"
#include "app/session/examine.h"

class QLabel;
class QPushButton;
class QScrollArea;
class QStackedWidget;

namespace searig::app::desktop {

class GuidedMotion;
class MapView;
class TimePlot;
class WorkBar;

class DiagnosePage : public Page {
 public:
  explicit DiagnosePage(Shell& shell);

  /// The recording that would be diagnosed; it has been opened on Replay.
  void choose(std::shared_ptr<const Session> session);
  /// Instead of the recording's own, from the next diagnosis on.
  void use_model(const std::filesystem::path& file);
  /// Beside the window, which goes on.
  void diagnose();
  void wait();
  /// As one HTML file; throws std::runtime_error with one sentence.
  void save_report(const std::filesystem::path& file) const;

  /// Null while nothing has been found.
  std::shared_ptr<const Examined> examined() const { return examined_; }
  GuidedMotion& guided() { return *guided_; }
  QString caption() const override;
  QString message() const override;
  void set_theme(const Theme& theme) override;

 private:
  enum class Left { differences, experiment };  ///< pages of left_

  void make_actions();
  void make_layout();
  QWidget* make_right_side();
  void say(const QString& words);
  void show_result(std::shared_ptr<const Examined> examined);
  void show_residual();
  void show_range(Range time_s);
  void accept();
  void turn_to_experiment();
  void save_experiment();
  void write_report();
  void follow_state();
  const estimator::Finding* finding_with_motion() const;

  std::shared_ptr<const Session> session_;
  std::shared_ptr<const Examined> examined_;
  std::optional<std::filesystem::path> model_file_;
  Plot residual_;  ///< what residual_plot_ shows
  Range range_{0.0, 20.0};
  WorkBar* work_;
  QLabel* hint_;
  QLabel* model_;
  QLabel* verdict_;
  QLabel* finding_;
  TimePlot* residual_plot_;
  MapView* map_;
  QScrollArea* map_area_;
  QStackedWidget* left_;
  GuidedMotion* guided_;
  QPushButton* diagnose_;
  QPushButton* accept_;
  QPushButton* next_;
  QPushButton* report_;
};

}  // namespace searig::app::desktop
