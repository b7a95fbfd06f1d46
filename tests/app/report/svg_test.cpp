#include "app/report/svg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <sstream>

namespace searig::app {
namespace {

using Points = std::vector<std::pair<double, double>>;

/// The points of the first polyline painted in this hue.
Points polyline(const std::string& svg, const std::string& hue) {
  const std::regex pattern("<polyline[^>]*--" + hue + "[^>]*points=\"([^\"]*)\"");
  std::smatch match;
  if (!std::regex_search(svg, match, pattern)) return {};
  Points points;
  std::istringstream text(match[1]);
  double x = 0, y = 0;
  char comma = 0;
  while (text >> x >> comma >> y) points.emplace_back(x, y);
  return points;
}

Plot plot_of(std::vector<double> x, std::vector<double> y) {
  Plot plot{.title = "T", .x_label = "time (s)", .y_label = "torque (N·m)"};
  plot.series = {{"measured", std::move(x), std::move(y), Style::line, Hue::blue}};
  plot.x_range = Range{0, 10};
  plot.y_range = Range{-1, 1};
  return plot;
}

TEST(Svg, TheCurveIsWhereTheDataAre) {
  const Points points = polyline(to_svg(plot_of({0, 5, 10}, {-1, 0, 1})), "blue");
  ASSERT_EQ(points.size(), 3u);
  EXPECT_NEAR(points[1].first, 0.5 * (points[0].first + points[2].first), 0.2);
  EXPECT_NEAR(points[1].second, 0.5 * (points[0].second + points[2].second), 0.2);
  EXPECT_LT(points[0].first, points[2].first);
  EXPECT_GT(points[0].second, points[2].second);  // up is up
  EXPECT_GE(points[0].first, 0.0);
  EXPECT_LE(points[2].first, 900.0);
}

TEST(Svg, TheLegendIsAboveTheData) {
  const std::string svg = to_svg(plot_of({0, 10}, {0, 1}));
  std::smatch name;
  ASSERT_TRUE(std::regex_search(svg, name, std::regex("y=\"([0-9.]+)\">measured<")));
  const Points points = polyline(svg, "blue");
  for (const auto& point : points) EXPECT_GT(point.second, std::stod(name[1]));
}

TEST(Svg, BothAxesSayTheirUnit) {
  const std::string svg = to_svg(plot_of({0, 10}, {0, 1}));
  EXPECT_NE(svg.find(">time (s)<"), std::string::npos);
  EXPECT_NE(svg.find(">torque (N·m)<"), std::string::npos);
}

std::size_t count(const std::string& svg, const std::string& shape) {
  std::size_t shapes = 0;
  for (auto at = svg.find(shape); at != std::string::npos; at = svg.find(shape, at + 1)) ++shapes;
  return shapes;
}

TEST(Svg, AValueThatIsNotFiniteBreaksTheLine) {
  const std::string svg = to_svg(plot_of({0, 1, 2, 3, 4, 5}, {0, 1, std::nan(""), 0, 1, 0}));
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(count(svg, "<polyline"), 2u);
}

TEST(Svg, AValueThatIsNotFiniteBreaksTheBand) {
  Plot plot = plot_of({0, 1, 2, 3, 4, 5}, {0, 1, std::nan(""), 0, 1, 0});
  plot.series[0].style = Style::band;
  plot.series[0].y_high = {1, 1, 1, 1, 1, 1};
  const std::string svg = to_svg(plot);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(count(svg, "<polygon"), 2u);
}

TEST(Svg, AMillionPointsStaySmall) {
  std::vector<double> x, y;
  for (int i = 0; i < 1000000; ++i) {
    x.push_back(1e-5 * i);
    y.push_back(std::sin(0.1 * i));
  }
  EXPECT_LT(to_svg(plot_of(std::move(x), std::move(y))).size(), 60000u);
}

TEST(Svg, ACurveThatTurnsBackIsDrawnWhole) {
  const Points points = polyline(to_svg(plot_of({0, 5, 2, 9}, {0, 1, -1, 0})), "blue");
  EXPECT_EQ(points.size(), 4u);
}

TEST(Svg, NoDataIsNoFailure) {
  EXPECT_NE(to_svg(Plot{}).find("</svg>"), std::string::npos);
  EXPECT_NE(to_svg(plot_of({}, {})).find("</svg>"), std::string::npos);
  EXPECT_NE(to_svg(CellMap{}).find("</svg>"), std::string::npos);
}

TEST(Svg, WordsCannotBreakThePicture) {
  Plot plot = plot_of({0, 1}, {0, 1});
  plot.title = "a < b & \"c\"";
  const std::string svg = to_svg(plot);
  EXPECT_NE(svg.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
  EXPECT_EQ(svg.find("a < b"), std::string::npos);
}

TEST(Svg, AMapShowsSignAndSizeByColour) {
  CellMap map{.title = "where", .value_label = "residual"};
  map.rows = {{"deflection (rad)", {-0.1, 0.0, 0.1, 0.2}, {-5.0, 0.0, 2.5}}};
  map.full_scale = 5.0;
  const std::string svg = to_svg(map);
  const auto cell = [&](const std::string& hue, const std::string& opacity) {
    return std::regex_search(svg,
                             std::regex("height=\"24\" fill=\"var\\(--" + hue + "\\)\"" + opacity));
  };
  EXPECT_TRUE(cell("blue", "/>"));                              // full
  EXPECT_TRUE(cell("vermilion", " fill-opacity=\"0.500\"/>"));  // half
  EXPECT_TRUE(cell("vermilion", " fill-opacity=\"0.000\"/>"));  // nothing
}

}  // namespace
}  // namespace searig::app
