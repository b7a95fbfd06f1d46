#include "app/desktop/diagnose/diagnose_page.h"

#include <QLabel>
#include <QVBoxLayout>

namespace searig::app::desktop {

DiagnosePage::DiagnosePage(Shell& shell)
    : Page(QStringLiteral("Diagnose"), shell), hint_(new QLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(14, 14, 14, 14);
  layout->addWidget(hint_);
  layout->addStretch(1);
  hint_->setWordWrap(true);
  hint_->setObjectName(QStringLiteral("hint"));
  hint_->setText(QStringLiteral("Open a recording with Ctrl+O; then it can be diagnosed here."));
}

void DiagnosePage::choose(const std::filesystem::path& recording) {
  recording_ = recording;
  hint_->setText(
      QStringLiteral("For now on the command line: searig diagnose %1 --report finding.html")
          .arg(QString::fromStdString(recording.string())));
}

QString DiagnosePage::message() const {
  return hint_->text();
}

}  // namespace searig::app::desktop
