#include "app/desktop/main_window.h"

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QMenuBar>
#include <QTabBar>
#include <QTabWidget>

#include "app/desktop/diagnose/diagnose_page.h"
#include "app/desktop/live/live_page.h"
#include "app/desktop/replay/replay_page.h"

namespace searig::app::desktop {

MainWindow::MainWindow(const Theme& theme)
    : theme_(theme),
      tabs_(new QTabWidget(this)),
      live_(new LivePage(*this)),
      replay_(new ReplayPage(*this)),
      diagnose_(new DiagnosePage(*this)) {
  resize(1280, 800);
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setFocusPolicy(Qt::NoFocus);  // the arrow keys are the page's
  setCentralWidget(tabs_);
  for (Page* page :
       {static_cast<Page*>(live_), static_cast<Page*>(replay_), static_cast<Page*>(diagnose_)})
    tabs_->addTab(page, page->name());
  make_actions();
  set_theme(theme);
  connect(tabs_, &QTabWidget::currentChanged, this, [this] { turn_to_page(); });
  turn_to_page();
}

void MainWindow::make_actions() {
  QMenu* file = menuBar()->addMenu(QStringLiteral("&File"));
  QAction* open = file->addAction(QStringLiteral("&Open recording…"));
  open->setShortcut(QKeySequence::Open);
  connect(open, &QAction::triggered, this, [this] { choose_recording(); });
  file->addSeparator();
  QAction* quit = file->addAction(QStringLiteral("&Quit"));
  quit->setShortcut(QKeySequence::Quit);
  connect(quit, &QAction::triggered, this, [this] { close(); });

  QMenu* view = menuBar()->addMenu(QStringLiteral("&View"));
  for (int i = 0; i < tabs_->count(); ++i) {
    QAction* turn = view->addAction(tabs_->tabText(i));
    turn->setShortcut(QKeySequence(int(Qt::CTRL) | (int(Qt::Key_1) + i)));
    connect(turn, &QAction::triggered, this, [this, i] { tabs_->setCurrentIndex(i); });
  }
  view->addSeparator();
  QAction* dark = view->addAction(QStringLiteral("&Dark"));
  dark->setShortcut(QKeySequence(int(Qt::CTRL) | Qt::Key_D));
  dark->setCheckable(true);
  dark->setChecked(theme_.dark());
  connect(dark, &QAction::toggled, this, [this](bool on) {
    Theme(on).apply(*qApp);
    set_theme(Theme(on));
  });
}

Page& MainWindow::page_in_front() const {
  return *static_cast<Page*>(tabs_->currentWidget());
}

void MainWindow::show_page(const QString& name) {
  for (int i = 0; i < tabs_->count(); ++i)
    if (tabs_->tabText(i).toLower() == name) tabs_->setCurrentIndex(i);
}

/// Only the menu of the page in front is there: Qt heeds the keys of a menu that is hidden too, and
/// the same key may serve several pages.
void MainWindow::turn_to_page() {
  for (int i = 0; i < tabs_->count(); ++i)
    menuBar()->removeAction(static_cast<Page*>(tabs_->widget(i))->menu()->menuAction());
  menuBar()->addMenu(page_in_front().menu());
  page_in_front().setFocus();
  caption_changed();
}

void MainWindow::caption_changed() {
  const QString caption = page_in_front().caption();
  setWindowTitle(caption.isEmpty() ? QStringLiteral("searig")
                                   : caption + QStringLiteral(" – searig"));
}

bool MainWindow::open_recording(const std::filesystem::path& recording) {
  tabs_->setCurrentWidget(replay_);
  if (!replay_->open(recording)) return false;
  diagnose_->choose(recording);
  caption_changed();
  return true;
}

void MainWindow::choose_recording() {
  const QString file = QFileDialog::getOpenFileName(
      this, QStringLiteral("Open a recording"), {},
      QStringLiteral("Recordings (*.mcap recording.toml *.hebilog);;All files (*)"));
  if (file.isEmpty()) return;
  const std::filesystem::path path = file.toStdString();
  open_recording(path.filename() == "recording.toml" ? path.parent_path() : path);
}

void MainWindow::set_theme(const Theme& theme) {
  theme_ = theme;
  for (int i = 0; i < tabs_->count(); ++i) static_cast<Page*>(tabs_->widget(i))->set_theme(theme);
}

}  // namespace searig::app::desktop
