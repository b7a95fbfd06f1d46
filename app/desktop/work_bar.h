// Work that takes longer than a frame: off the window's thread, with progress and a way to stop it.
#pragma once

#include <QWidget>
#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <thread>

class QLabel;
class QProgressBar;
class QPushButton;

namespace searig::app::desktop {

/// One work at a time; the next one takes the place of one that still runs. Hidden while there is
/// none. All but Work itself is called on the window's thread.
class WorkBar : public QWidget {
 public:
  /// How work speaks to the window; may be copied.
  class Progress {
   public:
    /// Says what is being done and how much of it is (below 0: nobody knows); false: stop.
    bool operator()(const std::string& doing, double share) const;
    /// What there is so far: runs on the window's thread, unless the work was stopped.
    void show(std::function<void()> call) const;

   private:
    friend class WorkBar;
    struct Task;
    std::shared_ptr<Task> task_;
  };
  /// Runs on another thread, throws what goes wrong, and returns what shows its results, which
  /// runs on the window's thread unless the work was stopped.
  using Work = std::function<std::function<void()>(const Progress&)>;
  using Failed = std::function<void(const QString& why)>;

  explicit WorkBar(QWidget* parent);
  ~WorkBar() override;

  void start(const QString& doing, Work work, Failed failed);
  /// Its results never come. The window goes on at once, whether the work has noticed or not.
  void cancel();
  bool busy() const { return current_ != nullptr; }
  /// Lets the window live until there is no work; for tests and pictures.
  void wait();
  /// Called whenever work begins, ends or is stopped.
  void on_change(std::function<void()> changed) { changed_ = std::move(changed); }

 private:
  using Task = Progress::Task;
  struct Running {
    std::shared_ptr<Task> task;
    std::jthread thread;
  };

  void show_progress(const std::string& doing, double share);
  void finish();
  void drop_what_is_over();

  std::shared_ptr<Task> current_;
  std::list<Running> running_;
  std::function<void()> changed_;
  QLabel* doing_;
  QProgressBar* bar_;
  QPushButton* stop_;
};

}  // namespace searig::app::desktop
