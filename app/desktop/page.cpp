#include "app/desktop/page.h"

#include <QAction>
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

}  // namespace searig::app::desktop
