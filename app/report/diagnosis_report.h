// The diagnosis as one HTML file: the finding first, then what it rests on.
#pragma once

#include "app/report/diagnosis_plots.h"
#include "app/report/html.h"

namespace searig::app {

HtmlReport diagnosis_report(const Examined& examined);

}  // namespace searig::app
