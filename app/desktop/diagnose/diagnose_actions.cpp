// What the keys and buttons of Diagnose do with a finding.
#include <QAction>
#include <QFileDialog>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <stdexcept>

#include "acquisition/recording/text_file.h"
#include "app/desktop/diagnose/diagnose_page.h"
#include "app/desktop/diagnose/guided_motion.h"
#include "app/desktop/work_bar.h"
#include "app/report/diagnosis_report.h"
#include "app/session/extended_model.h"
#include "app/session/motion_spec.h"

namespace searig::app::desktop {

void DiagnosePage::make_actions() {
  const auto add = [this](const char* words, const QKeySequence& key, auto action) {
    connect(add_action(words, key), &QAction::triggered, this, action);
  };
  add("&Diagnose", QKeySequence(Qt::Key_D), [this] { diagnose(); });
  add("&Accept: extend the model", QKeySequence(Qt::Key_A), [this] { accept(); });
  add("&Next experiment", QKeySequence(Qt::Key_N), [this] { turn_to_experiment(); });
  add("Start or stop the &motion", QKeySequence(Qt::Key_Space), [this] {
    if (left_->currentIndex() == int(Left::experiment)) guided_->toggle();
  });
  add("&Report as a page…", QKeySequence(Qt::Key_P), [this] { write_report(); });
  add("&Stop", QKeySequence(Qt::Key_Escape), [this] { work_->cancel(); });
  menu()->addSeparator();
  const auto span = [this] { return range_.high - range_.low; };
  const auto zoom = [this, span](double factor) {
    const double middle = 0.5 * (range_.low + range_.high), half = 0.5 * factor * span();
    show_range({middle - half, middle + half});
  };
  const auto move = [this, span](double share) {
    show_range({range_.low + share * span(), range_.high + share * span()});
  };
  add("Zoom &in", QKeySequence(Qt::Key_Plus), [zoom] { zoom(0.5); });
  add("Zoom &out", QKeySequence(Qt::Key_Minus), [zoom] { zoom(2.0); });
  add("&Earlier", QKeySequence(Qt::Key_Left), [move] { move(-0.25); });
  add("&Later", QKeySequence(Qt::Key_Right), [move] { move(0.25); });
  add("&Whole recording", QKeySequence(Qt::Key_Home), [this] { show_residual(); });
}

void DiagnosePage::accept() {
  if (!accept_->isEnabled()) return;
  try {
    const auto file = keep_extended_model(session_->recording.path, examined_->diagnosis.extended);
    shell().use_model(file);
    say(QStringLiteral("Written: %1. D diagnoses again with it; on Replay (Ctrl+2) R runs the "
                       "estimator, or the model's simulation, with it.")
            .arg(QString::fromStdString(file.string())));
  } catch (const std::exception& error) {
    say(QString::fromUtf8(error.what()));
  }
}

const estimator::Finding* DiagnosePage::finding_with_motion() const {
  if (!examined_) return nullptr;
  const auto& findings = examined_->diagnosis.findings;
  for (auto f = findings.rbegin(); f != findings.rend(); ++f)  // the least sure first
    if (f->next_motion) return &*f;
  return nullptr;
}

void DiagnosePage::turn_to_experiment() {
  if (left_->currentIndex() == int(Left::experiment)) {
    guided_->stop();
    return left_->setCurrentIndex(int(Left::differences));
  }
  const auto* finding = finding_with_motion();
  if (!finding) return say(QStringLiteral("No motion is known that would tell more here."));
  guided_->show_motion(*finding->next_motion,
                       QStringLiteral("It settles most of what is open about %1.")
                           .arg(QString::fromStdString(finding->effect)));
  left_->setCurrentIndex(int(Left::experiment));
}

void DiagnosePage::save_experiment() {
  const auto* finding = finding_with_motion();
  const QString file =
      QFileDialog::getSaveFileName(this, QStringLiteral("Save the motion"),
                                   QStringLiteral("next.toml"), QStringLiteral("Motions (*.toml)"));
  if (file.isEmpty() || !finding) return;
  try {
    acquisition::write_text_file(file.toStdString(),
                                 to_toml(*finding->next_motion, examined_->diagnosis.extended));
    say(QStringLiteral("Written: %1, for the rig and for searig simulate.").arg(file));
  } catch (const std::exception& error) {
    say(QString::fromUtf8(error.what()));
  }
}

void DiagnosePage::save_report(const std::filesystem::path& file) const {
  if (!examined_)
    throw std::runtime_error("Nothing has been diagnosed yet: D on Diagnose (Ctrl+3) does it.");
  diagnosis_report(*examined_).write(file);
}

void DiagnosePage::write_report() {
  if (!examined_) return say(QStringLiteral("Diagnose first, with D."));
  const QString file = QFileDialog::getSaveFileName(this, QStringLiteral("Write the report"),
                                                    caption() + QStringLiteral(".html"),
                                                    QStringLiteral("Pages (*.html)"));
  if (file.isEmpty()) return;
  try {
    save_report(file.toStdString());
    say(QStringLiteral("Written: %1. It opens in any browser.").arg(file));
  } catch (const std::exception& error) {
    say(QString::fromUtf8(error.what()));
  }
}

}  // namespace searig::app::desktop
