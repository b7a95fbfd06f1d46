// Which rig: two devices by name, and what is known of them.
#pragma once

#include <QGroupBox>
#include <QTimer>
#include <string>
#include <vector>

#include "app/rig/rig_session.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace searig::app::desktop {

class ConnectPanel : public QGroupBox {
 public:
  explicit ConnectPanel(QWidget* parent = nullptr);

  /// What is chosen. Throws with one sentence where a file cannot be used.
  RigOptions options() const;
  void choose(const std::string& module, const std::string& loadcell);
  void set_simulation(const DeviceOptions& simulation) { simulation_ = simulation; }
  void set_calibration(const std::string& file);
  void set_model(const std::string& file);

  /// While connected nothing can be chosen.
  enum class State { away, connecting, connected };
  void show_state(State state);
  /// Into which keys go.
  std::vector<QWidget*> fields() const;
  QPushButton* button() const { return button_; }

 private:
  void look_for_ports();
  void show_model();
  void choose_file(const QString& title, const QString& filter, std::string& file, QPushButton* on);

  QComboBox *loadcell_, *module_;
  QDoubleSpinBox* lever_arm_;
  QPushButton *calibration_, *model_, *button_;
  std::string calibration_file_, model_file_;
  DeviceOptions simulation_;
  QTimer ports_;
};

}  // namespace searig::app::desktop
