// The test bench: turns terms into whitened columns and fits sets of them.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "estimator/diagnosis/fit/noise.h"
#include "estimator/diagnosis/fit/regression.h"
#include "estimator/diagnosis/method.h"
#include "estimator/diagnosis/rows/experiment.h"
#include "estimator/physics/effect.h"

namespace searig::estimator {

/// A feature that has no name in the catalogue: what stands in for physics nobody has listed.
struct Atom {
  std::string what;     ///< in words: "a bump at a deflection"
  Path path;            ///< spring, drive or rig
  std::string channel;  ///< over which it is local: "deflection_rad", "time_s", ...
  double from = 0.0, to = 0.0;
  bool at_once = false;     ///< it is `from` that matters: something changes there, for good
  Eigen::VectorXd feature;  ///< on the motion's samples
  /// The feature for another place, where the place is a matter of degree; else empty.
  std::function<Eigen::VectorXd(double from, double to)> at = {};
};

/// One term of a hypothesis: an effect at a shape, or an atom.
struct Piece {
  const Effect* effect = nullptr;
  std::vector<double> shape;
  const Atom* atom = nullptr;
};

/// A set of terms that is fitted together, with the bench's nuisances.
using Hypothesis = std::vector<Piece>;

struct Fit {
  Solution solution;
  Eigen::MatrixXd columns;  ///< whitened: pieces in order, then nuisances; linearised (FreeScale)
  Eigen::MatrixXd free_columns;     ///< the same without nuisances that are at their bound
  Eigen::VectorXd free_right;       ///< what is left for the free columns to explain
  std::vector<Eigen::Index> first;  ///< first column of each piece; tied pieces point to theirs
  std::vector<Eigen::Index> count;

  Eigen::VectorXd amplitudes(std::size_t piece) const {
    return solution.coefficients.segment(first[piece], count[piece]);
  }
};

/// Nuisances, always refitted: the load cell's offset, one per part; its delay within what the
/// clock map leaves open; the shape of its averaging; a small skew and width between current and
/// angles.
class Bench {
 public:
  explicit Bench(Experiment experiment, Method method = {});

  const Experiment& experiment() const { return experiment_; }
  const Method& method() const { return method_; }
  const Whitening& whitening() const { return *whitening_; }

  /// Learns the noise from what the hypothesis leaves once `cleaners` have taken out of it what
  /// they can, so that missing physics is not taken for noise.
  void learn_noise(const Hypothesis& hypothesis, const std::vector<Piece>& cleaners);
  void set_noise(Whitening whitening);
  /// Noise as another bench learnt it, at the same rates.
  void take_noise_of(const Bench& other);
  /// The torque that delay, lag and load friction act on: the hypothesis's own.
  void learn_torque(const Hypothesis& hypothesis);

  Fit fit(const Hypothesis& hypothesis) const;
  /// The columns of a fit alone.
  Eigen::MatrixXd whitened(const Hypothesis& hypothesis) const;
  /// The same with nothing but their priors to hold the nuisances.
  Fit unbounded_fit(const Hypothesis& hypothesis) const;
  /// Residual before whitening, in N*m, prior rows included.
  Eigen::VectorXd raw_residual(const Hypothesis& hypothesis) const;
  /// One piece's whitened columns, as the load cell sees them at the given delay and lag.
  const Eigen::MatrixXd& columns(const Piece& piece, double delay_s, double lag_s) const;
  /// The same before whitening, one column per amplitude, prior rows included.
  const Eigen::MatrixXd& raw_columns(const Piece& piece, double delay_s, double lag_s) const;
  /// Linear stand-in for a delay or lag while candidates are screened.
  Eigen::MatrixXd screening_columns(const Piece& piece) const;
  Eigen::MatrixXd stack(Path path, const Eigen::MatrixXd& features, double delay_s,
                        double lag_s) const;
  Eigen::VectorXd right() const;
  /// Nuisance columns in N*m, stacked with their prior rows.
  const Eigen::MatrixXd& raw_nuisances() const { return raw_nuisance_; }
  Eigen::Index nuisance_count() const { return raw_nuisance_.cols(); }
  /// The last of them: what a prior holds, in standard deviations of it.
  static constexpr Eigen::Index prior_count = 6;
  Eigen::Index total_rows() const { return experiment_.rows() + prior_count; }

  /// Blocks of about `seconds`; -1 for prior rows.
  std::vector<int> blocks(double seconds = 10.0) const;

 private:
  static constexpr double nuisance_bound = 2.2;  // standard deviations of the prior

  Eigen::MatrixXd nuisances() const;
  Eigen::MatrixXd adapting_stiffness() const;
  Eigen::MatrixXd assemble(const Hypothesis& hypothesis, Fit& fit, bool whitened) const;
  void hold_scale(const Hypothesis& hypothesis, const std::vector<Eigen::Index>& first,
                  Eigen::Index own, Eigen::MatrixXd& columns, Eigen::VectorXd& right);
  Solution solve_scaled(const Hypothesis& hypothesis, Fit& fit) const;

  Experiment experiment_;
  Method method_;
  std::optional<Whitening> whitening_;
  double gain_ = 0.0;    // of the motor when the noise was learnt, N*m per A; 0 where it has none
  double late_s_ = 0.0;  // of the load cell, in the hypothesis that the torque was learnt from
  Eigen::VectorXd torque_;  // on the motion's samples, as the load cell would see it undisturbed
  Eigen::MatrixXd raw_nuisance_, nuisance_;
  /// Columns by piece; a copy of the bench makes its own.
  struct Cache : std::map<std::string, Eigen::MatrixXd> {
    Cache() = default;
    Cache(const Cache&) : map() {}
    Cache& operator=(const Cache&) = delete;
  };
  mutable Cache raw_cache_, cache_;
};

Hypothesis all_but(Hypothesis hypothesis, std::size_t piece);

/// Delay and lag that a hypothesis holds; zero where it has none.
struct Seen {
  double delay_s = 0.0, lag_s = 0.0;
};
Seen seen_by(const Hypothesis& hypothesis);

}  // namespace searig::estimator
