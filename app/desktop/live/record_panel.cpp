#include "app/desktop/live/record_panel.h"

#include <QDateTime>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardPaths>

#include "app/rig/live_verdict.h"

namespace searig::app::desktop {

RecordPanel::RecordPanel(QWidget* parent)
    : QGroupBox(QStringLiteral("Recording"), parent),
      folder_(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation).toStdString()),
      name_(new QLineEdit),
      notes_line_(new QLineEdit),
      status_(new QLabel),
      button_(new QPushButton),
      marker_(new QPushButton(QStringLiteral("Mark   M"))),
      open_(new QPushButton(QStringLiteral("Open in Replay   O"))) {
  folder_ /= "searig";
  name_->setObjectName(QStringLiteral("name"));
  name_->setPlaceholderText(QStringLiteral("the date and hour   N"));
  notes_line_->setObjectName(QStringLiteral("notes"));
  notes_line_->setPlaceholderText(QStringLiteral("kept in it   Shift+N"));
  for (auto* line : {name_, notes_line_}) line->setFocusPolicy(Qt::ClickFocus);
  status_->setObjectName(QStringLiteral("recording"));
  status_->setWordWrap(true);
  button_->setObjectName(QStringLiteral("record"));
  marker_->setObjectName(QStringLiteral("marker"));
  open_->setObjectName(QStringLiteral("open recorded"));
  auto* form = new QFormLayout(this);
  form->setContentsMargins(8, 4, 8, 8);
  form->setVerticalSpacing(4);
  form->addRow(QStringLiteral("Name"), name_);
  form->addRow(QStringLiteral("Notes"), notes_line_);
  auto* keys = new QHBoxLayout;
  keys->addWidget(button_, 2);
  keys->addWidget(marker_, 1);
  form->addRow(keys);
  form->addRow(status_);
  form->addRow(open_);
  show_status({}, false);
}

std::filesystem::path RecordPanel::next_file() const {
  const QString hour = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HHmmss"));
  const QString given = name_->text().trimmed().replace(QLatin1Char('/'), QLatin1Char('-'));
  const std::string stem = (given.isEmpty() ? hour : given).toStdString();
  std::filesystem::path file = folder_ / (stem + ".mcap");
  for (int again = 2; std::filesystem::exists(file); ++again)
    file = folder_ / (stem + "-" + std::to_string(again) + ".mcap");
  return file;
}

std::string RecordPanel::notes() const {
  return notes_line_->text().toStdString();
}

void RecordPanel::show_status(const RecordingStatus& status, bool connected) {
  button_->setEnabled(connected || status.running);
  button_->setText(status.running ? QStringLiteral("Stop   R") : QStringLiteral("Record   R"));
  marker_->setEnabled(status.running);
  for (QWidget* widget : {name_, notes_line_}) widget->setEnabled(!status.running);
  const bool recorded = !status.running && !status.file.empty();
  open_->setVisible(recorded && status.failure.empty());
  QString words = QStringLiteral("Nothing is written while only looking.");
  if (!status.failure.empty())
    words = QString::fromStdString(status.failure);
  else if (!status.file.empty())
    words = (status.running ? QStringLiteral("Into %1: %2") : QStringLiteral("Kept in %1: %2"))
                .arg(QString::fromStdString(status.file.filename().string()),
                     QString::fromStdString(recording_words(status)));
  status_->setText(words);
  status_->setToolTip(QString::fromStdString(status.file.string()));
}

}  // namespace searig::app::desktop
