// How sure: each accepted term against its rivals, everything else in place.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "estimator/diagnosis/diagnosis.h"
#include "estimator/diagnosis/search/search.h"

namespace searig::estimator {

/// A named piece of the final hypothesis, held against all rivals for its place.
struct Assessment {
  std::size_t piece = 0;         ///< in the final hypothesis
  Hypothesis without;            ///< the rest, polished
  std::optional<Scored> better;  ///< with a rival in its place, where that fits clearly better
  double gain = 0.0;             ///< what the piece brings
  double rho = 0.0;
  double probability = 0.0;
  std::vector<Alternative> alternatives;
  std::vector<Hypothesis> rivals;  ///< with the named ones of them in the piece's place
  bool consistent = true;          ///< whether both residuals that it enters agree on it
};

Assessment assess(Search& search, Bench& bench, const Scored& final, std::size_t piece);

/// Chance that a term is there at all, from what it gains and its size over the noise.
double existence(double gain, double rho);

/// Chance that a term is more than what another one leaves over because nature's form of that is
/// not the catalogue's; `share` is its size over that of the largest term.
double beyond_form(double share);

/// Names that, in the place of an atom of `final`, would explain nearly as much as it does.
std::set<std::string> names_near(Search& search, const Scored& final, std::size_t atom);

}  // namespace searig::estimator
