#include "app/desktop/replay/replay_page.h"

#include <QAction>
#include <QMenu>
#include <QVBoxLayout>
#include <utility>

#include "app/desktop/replay/history_view.h"

namespace searig::app::desktop {

ReplayPage::ReplayPage(Shell& shell)
    : Page(QStringLiteral("Replay"), shell), view_(new HistoryView(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(view_);
  view_->say(QStringLiteral("Open a recording with Ctrl+O."));
  make_actions();
}

void ReplayPage::make_actions() {
  const auto add = [this](const char* words, const QKeySequence& key, auto action) {
    connect(add_action(words, key), &QAction::triggered, this, action);
  };
  add("Zoom &in", QKeySequence(Qt::Key_Plus), [this] { view_->zoom(0.5); });
  add("Zoom &out", QKeySequence(Qt::Key_Minus), [this] { view_->zoom(2.0); });
  add("&Earlier", QKeySequence(Qt::Key_Left), [this] { view_->move(-0.25); });
  add("&Later", QKeySequence(Qt::Key_Right), [this] { view_->move(0.25); });
  add("&Whole recording", QKeySequence(Qt::Key_Home), [this] { view_->show_all(); });
}

bool ReplayPage::open(const std::filesystem::path& recording) {
  try {
    auto opened = std::make_unique<Recorded>(open_recorded(recording));
    view_->show_history(&opened->history, !opened->history.stiffness_nm_per_rad.empty());
    recorded_ = std::move(opened);  // the view has let go of the old one's columns
  } catch (const std::exception& error) {
    view_->say(QString::fromUtf8(error.what()));
    return false;
  }
  view_->say(QString::fromStdString(recorded_->remark));
  view_->show_numbers(recorded_->session.recording, recorded_->session.clock, false);
  view_->show_all();
  return true;
}

QString ReplayPage::caption() const {
  return recorded_ ? QString::fromStdString(recorded_->session.recording.name) : QString();
}

QString ReplayPage::message() const {
  return view_->said();
}

void ReplayPage::set_theme(const Theme& theme) {
  view_->set_theme(theme);
}

}  // namespace searig::app::desktop
