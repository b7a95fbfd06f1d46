#include "app/desktop/main_window.h"

#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QTabBar>
#include <QTabWidget>
#include <QUrl>
#include <QVBoxLayout>
#include <utility>

#include "app/desktop/diagnose/diagnose_page.h"
#include "app/desktop/help.h"
#include "app/desktop/live/live_page.h"
#include "app/desktop/replay/history_view.h"
#include "app/desktop/replay/replay_page.h"
#include "app/desktop/work_bar.h"

namespace searig::app::desktop {
namespace {

/// Of a recording in a folder, a file dialog and a file manager give a file.
std::filesystem::path recording_at(const QString& file) {
  const std::filesystem::path path = file.toStdString();
  return path.filename() == "recording.toml" ? path.parent_path() : path;
}

}  // namespace

MainWindow::MainWindow(const Theme& theme)
    : theme_(theme),
      tabs_(new QTabWidget(this)),
      live_(new LivePage(*this)),
      replay_(new ReplayPage(*this)),
      diagnose_(new DiagnosePage(*this)),
      work_(new WorkBar(this)),
      notice_(new QLabel(this)),
      help_(new Help(this)) {
  resize(1280, 800);
  setAcceptDrops(true);
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setFocusPolicy(Qt::NoFocus);  // the arrow keys are the page's
  notice_->setObjectName(QStringLiteral("notice"));
  notice_->setContentsMargins(14, 2, 14, 4);
  auto* centre = new QWidget(this);
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(tabs_, 1);
  layout->addWidget(work_);
  layout->addWidget(notice_);
  setCentralWidget(centre);
  for (Page* page :
       {static_cast<Page*>(live_), static_cast<Page*>(replay_), static_cast<Page*>(diagnose_)})
    tabs_->addTab(page, page->name());
  make_file_menu();
  make_view_menu();
  make_help_menu();
  set_theme(theme);
  say({});
  connect(tabs_, &QTabWidget::currentChanged, this, [this] { turn_to_page(); });
  turn_to_page();
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
  menuBar()->insertMenu(fixed_[2]->menuAction(), page_in_front().menu());
  page_in_front().setFocus();
  say({});
  caption_changed();
}

void MainWindow::caption_changed() {
  const QString caption = page_in_front().caption();
  setWindowTitle(caption.isEmpty() ? QStringLiteral("searig")
                                   : caption + QStringLiteral(" – searig"));
}

void MainWindow::say(const QString& words) {
  notice_->setText(words);
  notice_->setVisible(!words.isEmpty());
}

QString MainWindow::notice() const {
  return notice_->text();
}

void MainWindow::open_recording(const std::filesystem::path& recording) {
  open_recording(recording, {});
}

void MainWindow::open_recording(const std::filesystem::path& recording, const QString& view) {
  tabs_->setCurrentWidget(replay_);
  replay_->open(recording, [=, this](std::shared_ptr<const Session> session) {
    diagnose_->choose(std::move(session));
    replay_->take_view(view);
    store_.add_recent(QString::fromStdString(std::filesystem::absolute(recording).string()));
    list_recent();
  });
}

void MainWindow::choose_recording() {
  const QString file = QFileDialog::getOpenFileName(
      this, QStringLiteral("Open a recording"), {},
      QStringLiteral("Recordings (*.mcap recording.toml *.hebilog);;All files (*)"));
  if (!file.isEmpty()) open_recording(recording_at(file));
}

void MainWindow::use_model(const std::filesystem::path& model_file) {
  replay_->use_model(model_file);
  diagnose_->use_model(model_file);
}

bool MainWindow::lead(const estimator::PlannedMotion& motion) {
  if (!live_->lead(motion)) return false;
  tabs_->setCurrentWidget(live_);
  return true;
}

void MainWindow::mark_mismatch(const std::vector<Interval>& intervals) {
  replay_->view().shade(intervals, QStringLiteral("what the model misses shows most here"));
}

void MainWindow::continue_session(SessionStore store) {
  store_ = std::move(store);
  restoreGeometry(store_.geometry());
  show_page(store_.page());
  if (const auto dark = store_.dark()) set_dark(*dark);
  list_recent();
}

void MainWindow::reopen_last() {
  const QStringList recent = store_.recent();
  if (recent.isEmpty() || !std::filesystem::exists(recent.front().toStdString())) return;
  const QString page = page_in_front().name().toLower();
  open_recording(recent.front().toStdString(), store_.view());
  show_page(page);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  store_.keep_view(replay_->view_in_words());
  store_.keep_window(saveGeometry(), page_in_front().name().toLower(), theme_.dark());
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (!urls.isEmpty()) open_recording(recording_at(urls.front().toLocalFile()));
}

void MainWindow::set_dark(bool dark) {
  dark_->setChecked(dark);
}

void MainWindow::set_theme(const Theme& theme) {
  theme_ = theme;
  for (int i = 0; i < tabs_->count(); ++i) static_cast<Page*>(tabs_->widget(i))->set_theme(theme);
}

}  // namespace searig::app::desktop
