// The window: its pages, and what they share.
#pragma once

#include <QMainWindow>
#include <array>

#include "app/desktop/page.h"

class QTabWidget;

namespace searig::app::desktop {

class DiagnosePage;
class LivePage;
class ReplayPage;

class MainWindow : public QMainWindow, private Shell {
 public:
  explicit MainWindow(const Theme& theme);

  LivePage& live() { return *live_; }
  ReplayPage& replay() { return *replay_; }
  DiagnosePage& diagnose() { return *diagnose_; }

  /// Puts a page in front, by its name in small letters.
  void show_page(const QString& name);
  Page& page_in_front() const;
  bool open_recording(const std::filesystem::path& recording) override;
  void set_theme(const Theme& theme);

 private:
  void make_actions();
  void choose_recording();
  void turn_to_page();
  void caption_changed() override;

  Theme theme_;
  QTabWidget* tabs_;
  LivePage* live_;
  ReplayPage* replay_;
  DiagnosePage* diagnose_;
};

}  // namespace searig::app::desktop
