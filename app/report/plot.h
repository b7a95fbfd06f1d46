// A picture of data, said without a toolkit: what to draw, not how.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/palette.h"

namespace searig::app {

enum class Style {
  line,   ///< joined up; a value that is not finite breaks the line
  steps,  ///< holds each value until the next
  dots,   ///< one point each
  band    ///< the area between y and y_high
};

struct Series {
  std::string name;  ///< as the legend says it; empty: not in the legend
  std::vector<double> x;
  std::vector<double> y;
  Style style = Style::line;
  Hue hue = Hue::blue;
  std::vector<double> y_high = {};  ///< for a band
};

struct Range {
  double low = 0.0;
  double high = 1.0;
};

/// A stretch of x that something is said about.
struct Interval {
  double from = 0.0;
  double to = 0.0;
  Hue hue = Hue::vermilion;
};

/// A vertical line with a word beside it.
struct Mark {
  double x = 0.0;
  std::string text;
  Hue hue = Hue::ink;
};

/// A level across the whole plot, such as a limit or a true value.
struct Level {
  double y = 0.0;
  std::string name;
  Hue hue = Hue::ink;
};

struct Plot {
  std::string title;
  std::string x_label = {};  ///< with the unit: "time (s)"
  std::string y_label = {};
  std::vector<Series> series = {};
  std::vector<Interval> shaded = {};
  std::vector<Mark> marks = {};
  std::vector<Level> levels = {};
  std::string shaded_name = {};       ///< what the shading means, for the legend
  std::optional<Range> x_range = {};  ///< else what the data span
  std::optional<Range> y_range = {};
  std::optional<int> x_ticks = {};  ///< about so many; else as many as there is room for
};

/// Of a picture, in pixels.
struct Size {
  int width = 900;
  int height = 320;
};

/// A one-dimensional map: cells of a channel, each coloured by a signed number such as a
/// standardised residual. Grey is nothing, blue is below, vermilion is above.
struct CellMap {
  struct Row {
    std::string channel;         ///< with the unit: "deflection (rad)"
    std::vector<double> edges;   ///< one more than values
    std::vector<double> values;  ///< not finite: no data there
  };
  std::string title;
  std::string value_label;  ///< "residual (standard errors)"
  std::vector<Row> rows = {};
  double full_scale = 5.0;  ///< the value at which the colour is full
};

}  // namespace searig::app
