// How the two clocks stand to each other, and what got lost on the way.
#pragma once

#include <QGroupBox>

#include "app/rig/live_feed.h"

class QLabel;

namespace searig::app::desktop {

class SyncPanel : public QGroupBox {
 public:
  explicit SyncPanel(QWidget* parent = nullptr);

  void show(const LiveNews& news);

 private:
  QLabel *offset_, *rate_, *interval_, *module_, *loadcell_, *why_;
};

}  // namespace searig::app::desktop
