#include "app/desktop/theme.h"

#include <QApplication>
#include <QFont>
#include <QPalette>
#include <QStyleFactory>

namespace searig::app::desktop {

Theme Theme::of_system() {
  const QPalette palette = QApplication::palette();
  return Theme(palette.color(QPalette::Window).lightness() <
               palette.color(QPalette::WindowText).lightness());
}

void Theme::apply(QApplication& application) const {
  application.setStyle(QStyleFactory::create("Fusion"));
  QFont font = QApplication::font();
  font.setPointSizeF(10.0);
  QApplication::setFont(font);
  const QColor text = colour(Hue::ink), base = colour(ground), accent = colour(Hue::blue);
  const QColor window = dark_ ? base.lighter(130) : base.darker(104);
  QPalette palette;
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, window);
  palette.setColor(QPalette::Button, window);
  palette.setColor(QPalette::Mid, colour(grid));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                          QPalette::ToolTipText, QPalette::BrightText}) {
    palette.setColor(role, text);
  }
  palette.setColor(QPalette::ToolTipBase, window);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, base);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, colour(faint));
  }
  application.setPalette(palette);
}

}  // namespace searig::app::desktop
