// Light and dark, from the same palette as the reports.
#pragma once

#include <QColor>

#include "app/report/palette.h"

class QApplication;

namespace searig::app::desktop {

class Theme {
 public:
  explicit Theme(bool dark) : dark_(dark) {}

  /// The desktop's own preference.
  static Theme of_system();

  bool dark() const { return dark_; }
  QColor colour(Hue hue) const { return colour(shades(hue)); }
  QColor colour(const Shades& shades) const {
    return QColor(QLatin1String(dark_ ? shades.dark : shades.light));
  }
  /// Dresses every window of the program.
  void apply(QApplication& application) const;

 private:
  bool dark_;
};

}  // namespace searig::app::desktop
