#include "estimator/diagnosis/search/lasting_change.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/fit/left.h"
#include "estimator/diagnosis/search/refine.h"
#include "estimator/diagnosis/search/unnamed.h"

namespace searig::estimator {
namespace {

constexpr double least_share = 0.33;  // of the power of a residual
constexpr double least_gain = 60.0;   // in deviance; as of any atom
// Of the recording. A while that is longer is not special. A change for good that leaves nothing
// before it could stand for the spring itself, and take it out of the drive's equation.
constexpr double longest_while = 0.6, longest_for_good = 0.85;

/// Noise without a memory, as loud as what the hypothesis leaves.
Bench without_memory(const Bench& bench, const Hypothesis& hypothesis) {
  const Experiment& e = bench.experiment();
  Bench out = bench;
  out.set_noise(Whitening(e, bench.raw_residual(hypothesis).head(e.rows()), false));
  return out;
}

}  // namespace

std::optional<Atom> lasting_change(const Bench& bench, const Hypothesis& hypothesis) {
  const Bench plain = without_memory(bench, hypothesis);
  const Eigen::VectorXd residual = plain.raw_residual(hypothesis);
  const double end_s = bench.experiment().motion.t.back();
  std::optional<Atom> best;
  double most = least_gain;
  std::vector<Atom> candidates = lasting_changes(bench.experiment().motion);
  for (Atom& atom : candidates) {  // where they lie the bench knows them by
    atom = refined(plain, hypothesis, atom);
    const double lasts_s = (atom.at_once ? end_s : atom.to) - atom.from;
    if (lasts_s > (atom.at_once ? longest_for_good : longest_while) * end_s) continue;
    const bool drive = atom.path == Path::drive;
    Hypothesis with = hypothesis;
    with.push_back({nullptr, {}, &atom});
    const Left before = left_of(plain, residual, drive);
    const Left after = left_of(plain, plain.raw_residual(with), drive);
    if (before.power() - after.power() < least_share * before.power()) continue;
    const double gain = before.badness() - after.badness();
    if (gain > most) most = gain, best = atom;
  }
  return best;
}

}  // namespace searig::estimator
