#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <vector>

#include "tests/proving/score/judge.h"

namespace searig::proving {

using Judgements = std::map<std::string, Judgement>;

double median(std::vector<double> values);

/// One line per stratum.
void print_table(const Judgements& all, std::ostream& out);

/// Of all findings given about this probability, how many are true; Brier score and the expected
/// calibration error.
nlohmann::json print_reliability(const Judgements& all, std::ostream& out);

/// The targets beside what was measured.
nlohmann::json print_targets(const Judgements& all, std::ostream& out);

}  // namespace searig::proving
