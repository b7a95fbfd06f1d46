// The rig while it runs.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <memory>

#include "app/desktop/page.h"
#include "app/rig/live_rig.h"

namespace searig::app::desktop {

class HistoryView;

class LivePage : public Page {
 public:
  explicit LivePage(Shell& shell);

  /// Starts the simulated rig; `ahead_s` of it have passed already.
  void start_simulated(double ahead_s = 0.0);

  QString caption() const override;
  QString message() const override;
  void set_theme(const Theme& theme) override;

 private:
  void make_actions();
  void tick();
  void zoom(double factor);
  bool following() const;

  std::unique_ptr<LiveRig> rig_;
  HistoryView* view_;
  QAction* pause_ = nullptr;
  QTimer timer_;
  QElapsedTimer since_start_;
  double ahead_s_ = 0.0;
  double span_s_ = 20.0;  ///< of what is shown while it follows
};

}  // namespace searig::app::desktop
