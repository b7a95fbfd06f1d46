// What a batch's page is put together from: parts that both commands use, and each one's sections.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "app/batch/summary.h"
#include "app/report/html.h"
#include "app/report/plot.h"

namespace searig::app {

/// Of a table on the page; all of them are in summary.csv.
inline constexpr std::size_t most_rows = 20;

/// Which number of the answers is drawn, and as what.
struct Curve {
  const char* name;
  const char* pointer;
  Hue hue;
};

/// One dot for each recording that has the number.
Plot over_recordings(const Summary& summary, const std::string& title, const std::string& y_label,
                     const std::vector<Curve>& curves);

/// Nothing where no recording has the numbers.
void add_figure(HtmlReport& page, const Plot& plot, const std::string& caption);

/// A table of kinds with how many recordings had each, the most frequent first. Nothing of none.
void add_counted(HtmlReport& page, const std::string& heading, const std::string& what,
                 const std::map<std::string, std::size_t>& recordings);

/// Says that a table of most_rows is not all; empty where it is.
std::string only_first(std::size_t all);

/// The q-quantile of sorted numbers: the largest that at most the share q of them is below.
double quantile(const std::vector<double>& sorted, double q);

/// The recordings that a number is largest in.
void add_worst(HtmlReport& page, const Summary& summary, const std::string& heading,
               const std::string& what, const char* pointer);

/// What the evaluations came to: stiffness and errors, each over the recordings.
void add_evaluations(HtmlReport& page, const Summary& summary);

/// What the diagnoses found, by kind, then stiffness and errors over the recordings.
void add_diagnoses(HtmlReport& page, const Summary& summary);

}  // namespace searig::app
