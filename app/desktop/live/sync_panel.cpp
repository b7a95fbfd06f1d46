#include "app/desktop/live/sync_panel.h"

#include <QFormLayout>
#include <QLabel>

#include "app/report/axis.h"

namespace searig::app::desktop {
namespace {

QString said(double value, int decimals) {
  return QString::fromStdString(number(value, decimals));
}

QLabel* new_label(const char* name) {
  auto* label = new QLabel(QStringLiteral("–"));
  label->setObjectName(QString::fromLatin1(name));
  return label;
}

QString counts_words(const acquisition::WireCounters& counters) {
  return QStringLiteral("%1 lost, %2 garbled")
      .arg(counters.lost_samples)
      .arg(acquisition::garbled(counters));
}

}  // namespace

SyncPanel::SyncPanel(QWidget* parent)
    : QGroupBox(QStringLiteral("Synchronisation"), parent),
      offset_(new_label("offset")),
      rate_(new_label("rate")),
      interval_(new_label("interval")),
      module_(new_label("module counts")),
      loadcell_(new_label("loadcell counts")),
      why_(new_label("why")) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(8, 4, 8, 8);
  form->setVerticalSpacing(3);
  form->addRow(QStringLiteral("Offset"), offset_);
  form->addRow(QStringLiteral("Rate"), rate_);
  form->addRow(QStringLiteral("Interval"), interval_);
  form->addRow(QStringLiteral("Module"), module_);
  form->addRow(QStringLiteral("Load cell"), loadcell_);
  form->addRow(why_);
  why_->setWordWrap(true);
  why_->hide();
}

void SyncPanel::show(const LiveNews& news) {
  module_->setText(counts_words(news.module.counters));
  loadcell_->setText(counts_words(news.loadcell.counters));
  if (!news.clock) {
    for (QLabel* label : {offset_, rate_, interval_}) label->setText(QStringLiteral("–"));
    why_->hide();
    return;
  }
  offset_->setText(said(news.clock->offset_s, 4) + QStringLiteral(" s"));
  rate_->setText(said(1e6 * (news.clock->rate - 1.0), 1) + QStringLiteral(" ppm"));
  interval_->setText(
      QStringLiteral("±%1 ms, %2")
          .arg(said(1e3 * news.clock->ci95_s, 2),
               news.clock->trusted ? QStringLiteral("trusted") : QStringLiteral("NOT TRUSTED")));
  const QString why = QString::fromStdString(news.clock->why);
  interval_->setToolTip(why);
  why_->setText(news.clock->trusted ? QString() : why);
  why_->setVisible(!news.clock->trusted);
}

}  // namespace searig::app::desktop
