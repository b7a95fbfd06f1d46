#include "app/desktop/readouts.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace searig::app::desktop {

Readouts::Readouts(QWidget* parent) : QWidget(parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 8, 14, 8);
  layout->setSpacing(36);
  layout->addStretch(1);
}

std::size_t Readouts::add(const QString& name, bool large) {
  auto* value = new QLabel(QStringLiteral("–"), this);
  auto* note = new QLabel(name, this);
  QFont font = value->font();
  font.setPointSizeF(large ? 20.0 : 14.0);
  font.setBold(large);
  value->setFont(font);
  note->setForegroundRole(QPalette::WindowText);
  note->setEnabled(false);  // the palette's fainter text
  auto* column = new QVBoxLayout;
  column->setSpacing(0);
  column->addWidget(value, 1, Qt::AlignLeft | Qt::AlignBottom);
  column->addWidget(note);
  auto* row = static_cast<QHBoxLayout*>(layout());
  row->insertLayout(row->count() - 1, column);
  readouts_.push_back({value, note, name});
  return readouts_.size() - 1;
}

void Readouts::set(std::size_t place, const QString& value, const QString& note) {
  readouts_[place].value->setText(value);
  readouts_[place].note->setText(note.isEmpty() ? readouts_[place].name
                                                : readouts_[place].name + ": " + note);
}

}  // namespace searig::app::desktop
