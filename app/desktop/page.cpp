#include "app/desktop/page.h"

#include <QAction>
#include <QKeyEvent>
#include <QMenu>

namespace searig::app::desktop {

Page::Page(const QString& name, Shell& shell)
    : shell_(shell), menu_(new QMenu(QStringLiteral("&") + name, this)) {
  setObjectName(name);
  setFocusPolicy(Qt::StrongFocus);
}

QAction* Page::add_action(const char* words, const QKeySequence& key) {
  QAction* action = menu_->addAction(QString::fromUtf8(words));
  action->setShortcut(key);
  return action;
}

void Page::hold_keys(QWidget& field) {
  field.installEventFilter(this);
}

bool Page::eventFilter(QObject* field, QEvent* event) {
  const bool press = event->type() == QEvent::KeyPress;
  if (press || event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter) {
      event->accept();  // not a menu's
      if (press) setFocus();
      return true;
    }
  }
  return QWidget::eventFilter(field, event);
}

}  // namespace searig::app::desktop
