// The catalogue of effects for people, written from the catalogue itself.
#pragma once

#include <string>

namespace searig::app {

/// docs/catalogue.md.
std::string catalogue_markdown();

/// One line per effect, for a terminal.
std::string catalogue_lines();

}  // namespace searig::app
