// The window: its pages, and what they share.
#pragma once

#include <QMainWindow>
#include <memory>

#include "app/desktop/page.h"
#include "app/desktop/session_store.h"
#include "app/session/session.h"

class QAction;
class QLabel;
class QMenu;
class QTabWidget;

namespace searig::app::desktop {

class DiagnosePage;
class Help;
class LivePage;
class ReplayPage;
class WorkBar;

class MainWindow : public QMainWindow, private Shell {
 public:
  explicit MainWindow(const Theme& theme);

  LivePage& live() { return *live_; }
  ReplayPage& replay() { return *replay_; }
  DiagnosePage& diagnose() { return *diagnose_; }

  /// Puts a page in front, by its name in small letters.
  void show_page(const QString& name);
  Page& page_in_front() const;
  void open_recording(const std::filesystem::path& recording) override;
  void use_model(const std::filesystem::path& model_file) override;
  bool lead(const estimator::PlannedMotion& motion) override;
  void mark_mismatch(const std::vector<Interval>& intervals) override;
  void set_theme(const Theme& theme);
  void set_dark(bool dark);  ///< the whole program

  /// Takes up size, page and recent recordings of the last session, and keeps this one's. What is
  /// open from now on is not looked at again: call it before anything is opened.
  void continue_session(SessionStore store);
  /// The recording that was open last, where there is still one.
  void reopen_last();
  /// What is in front, or its recording, as the kind of file that the name asks for. Says in
  /// notice() where it went, or why not.
  void export_to(const std::filesystem::path& file);
  QString notice() const;
  /// Until nothing is being exported; for tests.
  void wait_for_export();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void open_recording(const std::filesystem::path& recording, const QString& view);
  void make_file_menu();
  void make_export_menu(QMenu& menu);
  void make_view_menu();
  void make_help_menu();
  void list_recent();
  void choose_recording();
  void choose_export(const QString& kind, const QString& ending);
  void turn_to_page();
  void show_help();
  void caption_changed() override;
  void say(const QString& words);

  Theme theme_;
  SessionStore store_;
  QTabWidget* tabs_;
  LivePage* live_;
  ReplayPage* replay_;
  DiagnosePage* diagnose_;
  WorkBar* work_;
  QLabel* notice_;
  QAction* dark_ = nullptr;
  QMenu* recent_ = nullptr;
  QMenu* fixed_[3] = {};  ///< File, View, Help: there whatever page is in front
  Help* help_;
};

}  // namespace searig::app::desktop
