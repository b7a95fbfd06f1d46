// The menus that are there whatever page is in front.
#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QMenuBar>
#include <QTabWidget>

#include "app/desktop/diagnose/diagnose_page.h"
#include "app/desktop/help.h"
#include "app/desktop/live/live_page.h"
#include "app/desktop/main_window.h"
#include "app/desktop/replay/replay_page.h"

namespace searig::app::desktop {
namespace {

QKeySequence with_control(int key) {
  return QKeySequence(int(Qt::CTRL) | key);
}

}  // namespace

void MainWindow::make_file_menu() {
  QMenu* file = fixed_[0] = menuBar()->addMenu(QStringLiteral("&File"));
  QAction* open = file->addAction(QStringLiteral("&Open recording…"));
  open->setShortcut(QKeySequence::Open);
  connect(open, &QAction::triggered, this, [this] { choose_recording(); });
  recent_ = file->addMenu(QStringLiteral("&Recent"));
  list_recent();
  make_export_menu(*file->addMenu(QStringLiteral("&Export")));
  file->addSeparator();
  QAction* quit = file->addAction(QStringLiteral("&Quit"));
  quit->setShortcut(QKeySequence::Quit);
  connect(quit, &QAction::triggered, this, [this] { close(); });
}

void MainWindow::make_export_menu(QMenu& menu) {
  const auto add = [&](const char* words, const char* kind, const char* ending, int key = 0) {
    QAction* action = menu.addAction(QString::fromUtf8(words));
    if (key != 0) action->setShortcut(with_control(key));
    connect(action, &QAction::triggered, this,
            [=, this] { choose_export(QLatin1String(kind), QLatin1String(ending)); });
  };
  add("&Page as a picture (PNG)…", "Pictures", ".png", Qt::Key_P);
  add("Page's plots as a &drawing (SVG)…", "Drawings", ".svg", Qt::Key_G);
  menu.addSeparator();
  add("Recording as a &table (CSV)…", "Tables", ".csv", Qt::Key_E);
  add("Recording for &MATLAB (MAT)…", "MATLAB", ".mat", Qt::Key_M);
  add("Recording as &HDF5…", "HDF5", ".h5", Qt::Key_H);
  menu.addSeparator();
  add("Diagnosis as a &report (HTML)…", "Pages", ".html", Qt::Key_T);
}

void MainWindow::list_recent() {
  recent_->clear();
  for (const QString& recording : store_.recent()) {
    const QString name = QFileInfo(recording).fileName();
    QAction* open = recent_->addAction(name);
    open->setToolTip(recording);
    connect(open, &QAction::triggered, this,
            [=, this] { open_recording(recording.toStdString()); });
  }
  if (!recent_->isEmpty())
    recent_->actions().front()->setShortcut(
        QKeySequence(int(Qt::CTRL) | int(Qt::SHIFT) | Qt::Key_O));
  recent_->setEnabled(!recent_->isEmpty());
  recent_->setToolTipsVisible(true);
}

void MainWindow::make_view_menu() {
  QMenu* view = fixed_[1] = menuBar()->addMenu(QStringLiteral("&View"));
  for (int i = 0; i < tabs_->count(); ++i) {
    QAction* turn = view->addAction(tabs_->tabText(i));
    turn->setShortcut(with_control(int(Qt::Key_1) + i));
    connect(turn, &QAction::triggered, this, [this, i] { tabs_->setCurrentIndex(i); });
  }
  view->addSeparator();
  dark_ = view->addAction(QStringLiteral("&Dark"));
  dark_->setShortcut(with_control(Qt::Key_D));
  dark_->setCheckable(true);
  dark_->setChecked(theme_.dark());
  connect(dark_, &QAction::toggled, this, [this](bool on) {
    Theme(on).apply(*qApp);
    set_theme(Theme(on));
  });
}

void MainWindow::make_help_menu() {
  fixed_[2] = menuBar()->addMenu(QStringLiteral("&Help"));
  QAction* keys = fixed_[2]->addAction(QStringLiteral("&Keys"));
  keys->setShortcuts({QKeySequence(Qt::Key_F1), QKeySequence(Qt::Key_Question)});
  connect(keys, &QAction::triggered, this, [this] { show_help(); });
}

void MainWindow::show_help() {
  help_->show_keys(
      {fixed_[0], fixed_[1], fixed_[2], live_->menu(), replay_->menu(), diagnose_->menu()});
}

}  // namespace searig::app::desktop
