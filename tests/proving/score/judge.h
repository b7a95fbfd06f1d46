#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tests/proving/score/parameters.h"
#include "tests/proving/score/run.h"
#include "tests/proving/score/truth.h"

namespace searig::proving {

struct Asserted {
  double probability;
  bool true_one;
};

/// One answer held against the truth. Words mean what they mean in the practice's score.
struct Judgement {
  std::string stratum;
  std::set<std::string> found,
      mentioned;        ///< families in findings; in alternatives and undecidable
  bool failed = false;  ///< no answer at all
  bool unexplained = false;
  bool named = false;     ///< exactly the truth
  bool contains = false;  ///< the truth is among all that is mentioned
  bool silent = false;    ///< nothing found, nothing unexplained
  bool wrong = false;     ///< a name above 0.7 that is not there
  bool alarm = false;     ///< a null that was not left alone
  bool misnamed = false;  ///< a confident name for the nameless, and no word of doubt
  int true_positives = 0, false_positives = 0, false_negatives = 0;
  std::vector<Parameter> parameters;
  std::vector<Asserted> asserted;
  std::optional<double> overlap;
  bool local = false;  ///< the truth has a place
  std::vector<double> heldout_over_reachable;
  double seconds = 0.0;
  std::string verdict, error;

  bool right() const;
};

Judgement judge(const Truth& truth, const Run& run, const std::filesystem::path& recording);

}  // namespace searig::proving
