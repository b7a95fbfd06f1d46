// The long sections of the diagnosis report; diagnosis_report.cpp puts them in order.
#pragma once

#include <string>
#include <vector>

#include "app/report/html.h"
#include "app/session/examine.h"

namespace searig::app {

using Rows = std::vector<std::vector<std::string>>;  ///< of a table

/// What is missing, by how much, with its numbers and what else it could be.
void write_finding(HtmlReport& report, const Examined& examined, const estimator::Finding& finding);

/// The residual over time and over the channel in which it shows.
void write_pictures(HtmlReport& report, const Examined& examined);

/// The mismatch part by part, for each pair of the three torques.
void write_maps(HtmlReport& report, const Examined& examined);

}  // namespace searig::app
