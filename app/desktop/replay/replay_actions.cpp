// What the keys do on Replay.
#include <QAction>
#include <QCursor>
#include <QLineEdit>
#include <QMenu>

#include "app/desktop/plot/time_plot.h"
#include "app/desktop/replay/history_view.h"
#include "app/desktop/replay/replay_page.h"
#include "app/desktop/replay/run_panel.h"
#include "app/desktop/work_bar.h"

namespace searig::app::desktop {
namespace {

QKeySequence with(Qt::Modifier modifier, Qt::Key key) {
  return QKeySequence(int(modifier) | int(key));
}

}  // namespace

void ReplayPage::make_actions() {
  const auto add = [this](const char* words, const QKeySequence& key, auto action) {
    connect(add_action(words, key), &QAction::triggered, this, action);
  };
  add("Zoom &in", QKeySequence(Qt::Key_Plus), [this] { view_->zoom(0.5); });
  add("Zoom &out", QKeySequence(Qt::Key_Minus), [this] { view_->zoom(2.0); });
  add("&Earlier", QKeySequence(Qt::Key_Left), [this] { view_->move(-0.25); });
  add("&Later", QKeySequence(Qt::Key_Right), [this] { view_->move(0.25); });
  add("&Whole recording", QKeySequence(Qt::Key_Home), [this] { view_->show_all(); });
  add("Bac&k to where it was", QKeySequence(Qt::Key_Backspace), [this] { view_->back(); });
  menu()->addSeparator();
  add("Cursor &A here", QKeySequence(Qt::Key_A), [this] { set_cursor(false); });
  add("Cursor &B here", QKeySequence(Qt::Key_B), [this] { set_cursor(true); });
  add("A a bit earlier", with(Qt::SHIFT, Qt::Key_Left), [this] { step_cursor(false, -1); });
  add("A a bit later", with(Qt::SHIFT, Qt::Key_Right), [this] { step_cursor(false, 1); });
  add("B a bit earlier", with(Qt::ALT, Qt::Key_Left), [this] { step_cursor(true, -1); });
  add("B a bit later", with(Qt::ALT, Qt::Key_Right), [this] { step_cursor(true, 1); });
  add("&No cursors", QKeySequence(Qt::Key_C), [this] { view_->set_cursors({}); });
  menu()->addSeparator();
  add("&Run the estimator again", QKeySequence(Qt::Key_R), [this] { run_again(); });
  add("&First k of the next run", QKeySequence(Qt::Key_K),
      [this] { runs_->first_k()->setFocus(); });
  add("&Take the second run away", QKeySequence(Qt::Key_X), [this] { take_away(); });
  add("&Stop reading or estimating", QKeySequence(Qt::Key_Escape), [this] {
    if (!work_->busy()) return;
    work_->cancel();
    view_->say(QStringLiteral("Stopped. R runs the estimator, Ctrl+O opens a recording."));
  });
}

/// Where the pointer is, else in the middle.
void ReplayPage::set_cursor(bool second) {
  const Range shown = view_->range();
  double at_s = 0.5 * (shown.low + shown.high);
  for (TimePlot* plot : view_->plots())
    if (plot->canvas().underMouse())
      at_s = plot->time_at(plot->canvas().mapFromGlobal(QCursor::pos()).x());
  Cursors cursors = view_->cursors();
  (second ? cursors.b_s : cursors.a_s) = at_s;
  view_->set_cursors(cursors);
}

void ReplayPage::step_cursor(bool second, int pixels) {
  Cursors cursors = view_->cursors();
  auto& cursor = second ? cursors.b_s : cursors.a_s;
  if (!cursor) return set_cursor(second);
  const Range shown = view_->range();
  *cursor += pixels * (shown.high - shown.low) / view_->plots().front()->canvas().width();
  view_->set_cursors(cursors);
}

}  // namespace searig::app::desktop
