// The paper's figures as the twin gives them: a picture, its numbers, and what to make of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/plot.h"
#include "app/reproduce/reproduction.h"

namespace searig::app::reproduce {

/// Of a CSV file; all columns of a figure are as long as each other.
struct Column {
  std::string name;  ///< with its unit: "torque_nm"
  std::vector<double> values;
};

struct Figure {
  std::string name;   ///< of its files: "figure_03"
  std::string title;  ///< "Figure 3: the Mullins effect"
  Plot plot = {};
  Size size = {900, 320};
  std::vector<Column> columns = {};
  std::string paper = {};  ///< what the paper's figure shows
  std::string ours = {};   ///< what this one shows, with its numbers
  bool agrees = false;
  std::string verdict = {};  ///< what agrees, what does not, and why
};

/// Table I as a picture, then figures 3 to 7 and 9 to 11. What a figure says of itself is worked
/// out from the trials, not written down beforehand.
std::vector<Figure> figures(const Reproduction& all);

/// NAME.png and NAME.csv. Throws std::runtime_error with one sentence where one cannot be written.
void write_files(const Figure& figure, const std::filesystem::path& folder);

}  // namespace searig::app::reproduce
