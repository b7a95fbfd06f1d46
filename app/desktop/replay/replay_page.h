// A recording: opened, looked at, moved through, the estimator run over it again.
#pragma once

#include <QElapsedTimer>
#include <filesystem>
#include <functional>
#include <memory>

#include "app/desktop/page.h"
#include "app/session/estimator_run.h"

namespace searig::app::desktop {

class CursorTable;
class HistoryView;
class RunPanel;
class WorkBar;

class ReplayPage : public Page {
 public:
  explicit ReplayPage(Shell& shell);

  /// Of two runs that are shown over each other.
  enum class Place { first, second };

  /// Reads it beside the window, which goes on; then the page says why where it cannot be opened.
  /// What was open stays until then. `opened` is called once it is there.
  void open(const std::filesystem::path& recording,
            std::function<void(std::shared_ptr<const Session>)> opened = {});
  /// Of the runs to come.
  void use_model(const std::filesystem::path& file);
  /// Range and cursors in words, for the next session; and back again.
  QString view_in_words() const;
  void take_view(const QString& words);
  /// Until nothing is being read or estimated; for tests and pictures.
  void wait();

  bool busy() const;
  /// Whether there is an estimate to be seen, if only the beginning of it.
  bool estimate_shown() const { return first_ && !first_->history.t_s.empty(); }

  /// Null while none is open.
  std::shared_ptr<const Session> session() const { return session_; }
  HistoryView& view() { return *view_; }
  QString caption() const override;
  QString message() const override;
  void set_theme(const Theme& theme) override;

 private:
  using Run = std::shared_ptr<const EstimatorRun>;

  void make_actions();
  void show_session(std::shared_ptr<const Session> session);
  void run_again();
  void start_run(const RunSettings& settings, Place place);
  std::shared_ptr<EstimatorRun> begun_run(const RunSettings& settings) const;
  void show_growing(Run run, Place place);
  void show_runs(Run first, Run second);
  void tell_runs();
  void take_away();
  void set_cursor(bool second);
  void step_cursor(bool second, int pixels);

  std::shared_ptr<const Session> session_;
  Run first_, second_;
  QElapsedTimer since_grown_;  ///< since a run that comes was drawn
  WorkBar* work_;
  HistoryView* view_;
  CursorTable* cursors_;
  RunPanel* runs_;
};

}  // namespace searig::app::desktop
