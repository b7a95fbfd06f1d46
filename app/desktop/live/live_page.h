// The rig while it runs: connect, watch, record, calibrate.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "app/desktop/page.h"
#include "app/rig/live_verdict.h"
#include "app/rig/rig_session.h"

class QLabel;
class QListWidget;
class QStackedWidget;

namespace searig::app::desktop {

class CalibrationPanel;
class ConnectPanel;
class LivePlots;
class Readouts;
class RecordPanel;
class SyncPanel;

class LivePage : public Page {
 public:
  explicit LivePage(Shell& shell);
  ~LivePage() override;

  /// Opens what the panel has chosen, in the background; what goes wrong is said on the page.
  void connect_rig();
  /// A recording that runs is ended whole first, in the background too.
  void disconnect_rig();
  bool connected() const { return rig_ != nullptr; }
  /// Whether an earlier connection is still being let go of.
  bool closing() const { return !closing_.empty(); }
  /// Null while not connected.
  RigSession* rig() { return rig_.get(); }

  /// A recording as it looked live, until_s after its start; nothing is connected.
  void show_as_live(const std::filesystem::path& recording, double until_s);

  /// Leads through a motion while the rig is watched; false where there is none to watch.
  bool lead(const estimator::PlannedMotion& motion);
  void toggle_recording();
  void mark();
  void calibrate();

  /// The arrival of the newest sample that is shown, on the host's clock.
  double newest_host_s() const { return news_.newest_host_s; }

  ConnectPanel& choice() { return *choice_; }
  RecordPanel& recorder() { return *record_; }
  LivePlots& plots() { return *plots_; }

  QString caption() const override;
  QString message() const override;
  void set_theme(const Theme& theme) override;

 private:
  void make_layout();
  void make_actions();
  void tick();
  void take_rig();
  void show_numbers();
  void note_events(const LiveNews& news);
  void say(const QString& words);
  void show_hint();
  QString next_step() const;
  void close_rig();

  Theme theme_{false};
  std::unique_ptr<RigSession> rig_;
  bool shown_ = false;  ///< what was live once
  std::future<std::unique_ptr<RigSession>> connecting_;
  std::vector<std::future<void>> closing_;
  bool again_ = false;  ///< connect anew once the old one is closed
  LiveNews news_;       ///< the last, without its columns
  int frames_ = 0, marks_ = 0;
  bool has_model_ = true;
  QString verdict_why_;
  QString notice_;  ///< what was said last, for a while
  QElapsedTimer since_notice_;
  QTimer timer_;

  QStackedWidget* views_;
  LivePlots* plots_;
  CalibrationPanel* calibration_;
  ConnectPanel* choice_;
  RecordPanel* record_;
  SyncPanel* sync_;
  Readouts* readouts_;
  QLabel *rec_, *verdict_, *hint_;
  QListWidget* events_;
  QAction *connect_ = nullptr, *record_action_ = nullptr, *pause_ = nullptr, *calibrate_ = nullptr;
};

}  // namespace searig::app::desktop
