// What a window shows, pixel by pixel.
#pragma once

#include <QImage>
#include <QWidget>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "app/desktop/layout_description.h"
#include "app/report/palette.h"

namespace searig::app::desktop {

class Pixels {
 public:
  explicit Pixels(QWidget& window, bool dark = false)
      : image_(window.grab().toImage()),
        layout_(describe_layout(window)),
        scale_(window.devicePixelRatioF()),
        dark_(dark) {}

  /// Whether a pixel of that hue is within two pixels of where the plot shows (t, value).
  bool drawn(const std::string& plot, double t, double value, Hue hue) const {
    const auto& at = layout_["plots"][plot];
    const auto share = [](const nlohmann::json& range, double v) {
      return (v - double(range[0])) / (double(range[1]) - double(range[0]));
    };
    const double x = int(at["left"]) + share(at["x"], t) * (int(at["width"]) - 1);
    const double y = int(at["top"]) + (1.0 - share(at["y"], value)) * (int(at["height"]) - 1);
    const int px = int(std::lround(scale_ * x)), py = int(std::lround(scale_ * y));
    for (int dx = -2; dx <= 2; ++dx)
      for (int dy = -2; dy <= 2; ++dy)
        if (image_.valid(px + dx, py + dy) && is(image_.pixelColor(px + dx, py + dy), hue))
          return true;
    return false;
  }

 private:
  bool is(const QColor& seen, Hue hue) const {
    const QColor wanted(QLatin1String(dark_ ? shades(hue).dark : shades(hue).light));
    return std::abs(seen.red() - wanted.red()) + std::abs(seen.green() - wanted.green()) +
               std::abs(seen.blue() - wanted.blue()) <
           60;  // a line that is nearly level is smoothed
  }

  QImage image_;
  nlohmann::json layout_;
  double scale_;
  bool dark_;
};

}  // namespace searig::app::desktop
