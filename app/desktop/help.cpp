#include "app/desktop/help.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QStringList>
#include <QVBoxLayout>

namespace searig::app::desktop {
namespace {

constexpr int columns = 3;

QString without_mnemonic(QString words) {
  return words.remove(QLatin1Char('&')).toHtmlEscaped();
}

/// Submenus too, whose actions say whose they are.
QString rows_of(const QMenu& menu) {
  QString rows;
  for (const QAction* action : menu.actions()) {
    if (action->menu()) rows += rows_of(*action->menu());
    QStringList keys;
    for (const QKeySequence& key : action->shortcuts())
      keys << key.toString(QKeySequence::NativeText);
    if (keys.isEmpty()) continue;
    rows += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>")
                .arg(keys.join(QStringLiteral(" or ")).toHtmlEscaped(),
                     without_mnemonic(action->text()));
  }
  return rows;
}

}  // namespace

Help::Help(QWidget* parent) : QWidget(parent), keys_(new QLabel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(40, 30, 40, 30);
  layout->addWidget(keys_, 0, Qt::AlignTop);
  layout->addStretch(1);
  keys_->setObjectName(QStringLiteral("keys"));
  keys_->setTextFormat(Qt::RichText);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  setFocusPolicy(Qt::StrongFocus);
  hide();
}

void Help::show_keys(const std::vector<QMenu*>& menus) {
  QString cells;
  for (std::size_t i = 0; i < menus.size(); ++i) {
    if (i > 0 && i % columns == 0) cells += QStringLiteral("</tr><tr>");
    cells += QStringLiteral("<td style='padding:0 46px 22px 0'><h3>%1</h3><table>%2</table></td>")
                 .arg(without_mnemonic(menus[i]->title()), rows_of(*menus[i]));
  }
  keys_->setText(
      QStringLiteral(
          "<h2>Keys</h2><p>On the plots: drag to enlarge, wheel to zoom, Shift and wheel "
          "to move, double click for everything, click for cursor A, Shift and click for "
          "cursor B. Any key closes this.</p><table><tr>%1</tr></table>")
          .arg(cells));
  setGeometry(parentWidget()->rect());
  show();
  raise();
  setFocus();
}

/// Keys are not the menus' while this is in front.
bool Help::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::KeyPress || event->type() == QEvent::MouseButtonPress ||
      event->type() == QEvent::FocusOut) {
    hide();
    return true;
  }
  return QWidget::event(event);
}

}  // namespace searig::app::desktop
