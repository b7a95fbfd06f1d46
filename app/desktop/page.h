// One of the window's pages: its own view, its own menu, its own words.
#pragma once

#include <QString>
#include <QWidget>
#include <filesystem>
#include <vector>

#include "app/desktop/theme.h"
#include "app/report/plot.h"
#include "estimator/model/planned_motion.h"

class QAction;
class QKeySequence;
class QMenu;

namespace searig::app::desktop {

/// What a page may ask of the window around it.
class Shell {
 public:
  virtual ~Shell() = default;
  /// On the pages that show recordings; goes to Replay, which says why where it cannot be opened.
  virtual void open_recording(const std::filesystem::path& recording) = 0;
  /// From now on the model that recordings are held against.
  virtual void use_model(const std::filesystem::path& model_file) = 0;
  /// Where a diagnosis found the model of the opened recording wanting, seconds since its first
  /// telemetry; nowhere where nothing is known.
  virtual void mark_mismatch(const std::vector<Interval>& intervals) = 0;
  /// To Live, which leads through a motion; false where no rig is connected.
  virtual bool lead(const estimator::PlannedMotion& motion) = 0;
  /// The caption of a page has changed.
  virtual void caption_changed() = 0;
};

class Page : public QWidget {
 public:
  /// `name` is the tab's, and in small letters what --page takes.
  Page(const QString& name, Shell& shell);

  QString name() const { return objectName(); }
  /// Its actions. The menu is in the menu bar while the page is in front, and its keys hold then.
  QMenu* menu() const { return menu_; }
  /// What it shows, for the window's title: a recording's name.
  virtual QString caption() const { return {}; }
  /// What it has to say to the user now: the next step, or what went wrong.
  virtual QString message() const { return {}; }
  virtual void set_theme(const Theme& theme) = 0;
  /// Words that grow do not make the window grow.
  QSize minimumSizeHint() const override { return {900, 600}; }

 protected:
  /// An action in the menu; the key is shown beside it.
  QAction* add_action(const char* words, const QKeySequence& key);
  /// A field that keys go into until Return or Escape, which lead back to the page.
  void hold_keys(QWidget& field);
  bool eventFilter(QObject* field, QEvent* event) override;
  Shell& shell() const { return shell_; }

 private:
  Shell& shell_;
  QMenu* menu_;
};

}  // namespace searig::app::desktop
