// The load cell under known weights, step by step: tare, weights, fit, use.
#pragma once

#include <QWidget>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "acquisition/calibration/loadcell_calibration.h"
#include "app/rig/rig_session.h"
#include "app/rig/weighing.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace searig::app::desktop {

class CalibrationPanel : public QWidget {
 public:
  explicit CalibrationPanel(QWidget* parent = nullptr);

  /// Called with the file of a calibration that is to be used from now on.
  std::function<void(const std::filesystem::path&)> use;
  /// Called when the user is done, or gives up.
  std::function<void()> leave;

  void begin(const std::filesystem::path& folder, double lever_arm_m);
  /// What came since the last call; `rig` hangs the weights itself where it is simulated.
  void take(const LiveNews& news, RigSession& rig);

 protected:
  /// Return takes a reading, Escape leaves.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void read_weight();
  void fit();
  void show_readings();
  void save();
  void say(const QString& words);

  std::filesystem::path folder_;
  std::vector<acquisition::KnownWeight> weights_;
  std::optional<acquisition::LoadcellCalibration> calibration_;
  std::optional<Weighing> weighing_;
  bool hung_ = false;  ///< whether the simulated board was told of the weight
  double mass_kg_ = 0.0;

  QLabel *step_, *result_, *counts_;
  QDoubleSpinBox *mass_, *lever_arm_;
  QTableWidget* readings_;
  QPushButton *read_, *forget_, *save_, *leave_;
};

}  // namespace searig::app::desktop
