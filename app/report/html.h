// One HTML file that needs nothing beside it: text, tables and pictures, on screen and on paper.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/report/plot.h"
#include "app/report/svg.h"

namespace searig::app {

class HtmlReport {
 public:
  explicit HtmlReport(std::string_view title);

  void heading(std::string_view text);
  void paragraph(std::string_view text);
  /// A sentence that must not be missed, such as the verdict.
  void verdict(std::string_view text);
  /// Numbers worth seeing first: what it is, and its value with unit.
  void facts(const std::vector<std::pair<std::string, std::string>>& name_and_value);
  void table(const std::vector<std::string>& header,
             const std::vector<std::vector<std::string>>& rows, std::string_view caption = {});
  void figure(const Plot& plot, std::string_view caption, Size size = {});
  void figure(const CellMap& map, std::string_view caption);
  /// Two texts with their headings, next to each other where the page is wide enough.
  void beside(std::string_view left_heading, std::string_view left, std::string_view right_heading,
              std::string_view right);
  /// A plot without caption or number, for a page that numbers by itself.
  void picture(const Plot& plot, Size size = {});
  /// A picture that is SVG already.
  void figure_svg(std::string_view svg, std::string_view caption);
  /// Lines as they are, such as a model file.
  void code(std::string_view text);

  std::string text() const;
  /// Throws std::runtime_error with one sentence where the file cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  void caption(std::string_view text);

  std::string title_;
  std::string body_;
  int figures_ = 0;
};

}  // namespace searig::app
