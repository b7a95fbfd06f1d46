// The settings of the next run of the estimator, and what the runs so far came to.
#pragma once

#include <QWidget>
#include <functional>

#include "app/session/estimator_run.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace searig::app::desktop {

class RunPanel : public QWidget {
 public:
  explicit RunPanel(QWidget* parent);

  RunSettings settings() const;
  QLineEdit* first_k() const { return initial_k_; }
  /// From now on the model of the next run.
  void use_model(const std::filesystem::path& file);
  /// `second` may be null.
  void show_runs(const EstimatorRun* first, const EstimatorRun* second);
  void set_enabled(bool there_is_a_recording);

  void on_run(std::function<void()> run);
  void on_take_away(std::function<void()> take_away);

 private:
  void make_form();
  void choose_model(int place);
  void follow_kind();

  QComboBox* kind_;
  QComboBox* states_;
  QLineEdit* initial_k_;
  QComboBox* model_;
  QPushButton* run_;
  QPushButton* take_away_;
  QLabel* runs_;
  int chosen_model_ = 0;
};

}  // namespace searig::app::desktop
