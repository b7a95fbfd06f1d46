// Which terms are missing: forward selection with re-polishing, named effects against unnamed
// rivals.
#pragma once

#include <set>
#include <vector>

#include "estimator/diagnosis/fit/bench.h"

namespace searig::estimator {

/// A hypothesis with its best shapes, and how badly it fits.
struct Scored {
  Hypothesis hypothesis;
  /// Sum of squares in units of the noise that the bench had, plus the nuisances' priors; beyond
  /// four standard deviations it grows only linearly. Differences under one noise compare like
  /// chi-squared. The drive's residual counts in amperes, so that shrinking both sides of it gains
  /// nothing.
  double deviance = 0.0;
  /// Deviance that it must beat its rivals by, per further amplitude and shape value.
  double penalty = 0.0;

  double cost() const { return deviance + penalty; }
};

/// A candidate that was held against the same hypothesis: one piece, or two that hide each other.
struct Contender {
  std::vector<Piece> pieces;
  Scored scored;
  double gain = 0.0;  ///< fall of the cost against the hypothesis without it
};

/// What one step of the selection saw.
struct Step {
  Scored before;
  std::vector<Contender> named, unnamed;  ///< polished, best first
};

struct Criteria {
  double least_gain = 30.0;        ///< fall of the cost that a term must bring
  double least_unnamed_gain = 60;  ///< the same for an atom: there are many of them
  double least_unnamed_rho = 0.3;  ///< and the world is full of small nameless things
  double least_rho = 0.18;         ///< rms of the term over rms of the noise, in a block it enters
  double least_of_largest = 0.04;  ///< the same over that of the strongest term found
  double least_unnamed_of_largest = 0.15;  ///< below it, another form of the named effect will do
  int most_terms = 4;
};

class Search {
 public:
  Search(Bench& bench, const std::vector<Atom>& dense, const std::vector<Atom>& atoms,
         const Model& model, Criteria criteria = {});

  /// Noise as it is once the hypothesis, the dense map and the whole catalogue have had their say.
  void learn_noise(const Hypothesis& hypothesis);

  /// Polishes and scores under the noise that the bench has.
  Scored score(Hypothesis hypothesis);

  /// Holds all candidates against the hypothesis, under one noise; the best few are polished.
  Step step(const Hypothesis& from);

  /// Adds named effects while they pass; `trail` gets the steps, the last one being the one that
  /// added nothing.
  Scored add_named(Scored from, std::vector<Step>& trail);

  /// Adds atoms while they stand out.
  Scored add_unnamed(Scored from, int most);

  /// Adds whichever is better at each step, a name or an atom.
  Scored add_either(Scored from, int most);

  /// Whether the contender is strong enough to be asserted.
  bool passes(const Contender& contender, const Scored& from);

  /// And large enough beside the others: small remains of what they explain do not count.
  bool stands_out(const Contender& contender, const Scored& from);

  /// Whether blocks that a fit has not seen are the better for it.
  bool predicts(const Contender& contender, const Scored& from) const;

  /// Sum of squares, whitened, of blocks that were each predicted by a fit that did not see them.
  double heldout(const Hypothesis& hypothesis) const;

  const Criteria& criteria() const { return criteria_; }

 private:
  double deviance(const Fit& fit) const;
  Piece extended(const Hypothesis& from, const Effect& effect, std::vector<double> shape) const;
  struct Ranked {
    Piece piece;
    double gain = 0.0;
  };
  std::vector<Ranked> screen(const Hypothesis& from, const Projection& projection);
  std::vector<std::vector<Piece>> shortlist_named(const Hypothesis& from);
  std::vector<std::vector<Piece>> with_late_loadcell(const Hypothesis& from,
                                                     const std::vector<Piece>& pieces);
  std::vector<Piece> best_pair(const Hypothesis& from, const Projection& projection,
                               const std::vector<Ranked>& ranked);
  std::vector<std::vector<Piece>> shortlist_unnamed(const Hypothesis& from);
  Hypothesis with(Hypothesis from, const std::vector<Piece>& pieces) const;
  bool believable(const Contender& contender);
  bool at_its_bound(const Piece& piece) const;
  double left_of_drive(const Scored& scored) const;
  bool explains(const Contender& contender, double left_before) const;

  Bench& bench_;
  const std::vector<Atom>& atoms_;
  std::vector<Piece> cleaners_;
  const Model& model_;
  Criteria criteria_;
  std::set<const Effect*> given_;  // terms of the model: taken as they are
  double largest_ = 0.0;           // strength of the strongest term accepted so far
  double largest_of_drive_ = 0.0;  // and of the drive's own
};

/// rms over a block of what the fit takes out between two hypotheses, over the rms that remains;
/// the larger of the two blocks. Both under the later one's noise.
double strength(Bench& bench, const Scored& without, const Scored& with);

}  // namespace searig::estimator
