// The page that sets the paper beside the twin: one HTML file without outside resources.
#pragma once

#include <vector>

#include "app/report/html.h"
#include "app/reproduce/figure.h"

namespace searig::app::reproduce {

HtmlReport page(const Reproduction& all, const std::vector<Figure>& figures);

}  // namespace searig::app::reproduce
