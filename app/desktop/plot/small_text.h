// Words of plots, for the sources in this folder.
#pragma once

#include <qwt_text.h>

#include <QFont>

namespace searig::app::desktop {

inline QwtText small_text(const QString& words) {
  QwtText text(words);
  QFont font = text.font();
  font.setPointSizeF(9.0);
  font.setBold(false);
  text.setFont(font);
  return text;
}

}  // namespace searig::app::desktop
