// What leaves the window as files.
#include <QFileDialog>

#include "app/desktop/diagnose/diagnose_page.h"
#include "app/desktop/exports.h"
#include "app/desktop/main_window.h"
#include "app/desktop/replay/replay_page.h"
#include "app/desktop/work_bar.h"

namespace searig::app::desktop {

void MainWindow::choose_export(const QString& kind, const QString& ending) {
  const QString caption = page_in_front().caption();
  const QString name = (caption.isEmpty() ? QStringLiteral("searig") : caption) + ending;
  QString file = QFileDialog::getSaveFileName(this, QStringLiteral("Export"), name,
                                              QStringLiteral("%1 (*%2)").arg(kind, ending));
  if (file.isEmpty()) return;
  if (!file.endsWith(ending)) file += ending;
  export_to(file.toStdString());
}

void MainWindow::export_to(const std::filesystem::path& file) {
  const QString done = QStringLiteral("Written: %1").arg(QString::fromStdString(file.string()));
  const auto session = replay_->session();
  const ExportKind kind = export_kind(file);
  try {
    switch (kind) {
      case ExportKind::picture:
        save_picture(page_in_front(), file);
        return say(done);
      case ExportKind::drawing:
        save_drawing(page_in_front(), file);
        return say(done);
      case ExportKind::report:
        diagnose_->save_report(file);
        return say(done);
      case ExportKind::none:
        return say(QStringLiteral("%1: end the name with .png, .svg, .csv, .mat, .h5 or .html.")
                       .arg(QString::fromStdString(file.string())));
      default:
        break;
    }
  } catch (const std::exception& error) {
    return say(QString::fromUtf8(error.what()));
  }
  if (!session) return say(QStringLiteral("Open a recording first, with Ctrl+O."));
  say({});
  work_->start(
      QStringLiteral("Writing %1").arg(QString::fromStdString(file.filename().string())),
      [=, this, path = session->recording.path](const WorkBar::Progress&) -> std::function<void()> {
        save_recording(path, kind, file);
        return [=, this] { say(done); };
      },
      [this](const QString& why) { say(why); });
}

void MainWindow::wait_for_export() {
  work_->wait();
}

}  // namespace searig::app::desktop
