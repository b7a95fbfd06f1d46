// A recording so far as a few dozen sums: enough to fit a linear model again at any time, and to
// see how noisy it is.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

namespace searig::estimator {

/// Sums over a stretch of time. With x the residual's score is s = g - A x. Where the parameters
/// move, x and P are those at its end.
template <int n>
struct ScoreBlock {
  Eigen::Matrix<double, n, n> A = Eigen::Matrix<double, n, n>::Zero();  ///< sum w phi phi'
  Eigen::Vector<double, n> g = Eigen::Vector<double, n>::Zero();        ///< sum w phi T
  double seconds = 0;
  double resting_s = 0;  ///< of those
  double work = 0;       ///< done on the spring
  Eigen::Vector<double, n> x = Eigen::Vector<double, n>::Zero();
  Eigen::Matrix<double, n, n> P = Eigen::Matrix<double, n, n>::Zero();  ///< for a noise of 1

  bool is_rest() const { return 2 * resting_s > seconds || !(A.trace() > 0); }

  /// What passes in half of it.
  ScoreBlock half() const {
    ScoreBlock out = *this;
    out.seconds /= 2, out.resting_s /= 2, out.work /= 2;
    return out;
  }

  ScoreBlock& operator+=(const ScoreBlock& later) {
    A += later.A;
    g += later.g;
    seconds += later.seconds;
    resting_s += later.resting_s;
    work += later.work;
    x = later.x, P = later.P;
    return *this;
  }
};

/// Blocks of equal length, 24 to 47 of them once there is so much. Where there would be more,
/// neighbours are joined and blocks last twice as long; once they are as long as they may be, the
/// older half is dropped. A rest counts as one. Allocates nothing.
template <int n>
class ScoreBlocks {
 public:
  explicit ScoreBlocks(double longest_s) : longest_s_(longest_s) {}

  /// True where the sample has filled a block: the last one.
  bool add(const ScoreBlock<n>& sample) {
    open_ += sample;
    if (open_.seconds < block_s_) return false;
    if (count_ == blocks_.size()) make_room();
    if (count_ > 0 && open_.is_rest() && last().is_rest()) {
      last() += open_;
    } else {
      blocks_[count_++] = open_;
    }
    open_ = {};
    return true;
  }

  double length_s() const { return block_s_; }
  /// Whether every sample since the first is in a block.
  bool is_whole() const { return whole_; }
  std::span<const ScoreBlock<n>> closed() const { return {blocks_.data(), count_}; }
  std::span<ScoreBlock<n>> closed() { return {blocks_.data(), count_}; }
  ScoreBlock<n>& last() { return blocks_[count_ - 1]; }

 private:
  void make_room() {
    count_ /= 2;
    const bool joins = 2 * block_s_ <= longest_s_;
    for (std::size_t i = 0; i < count_; ++i) {
      blocks_[i] = joins ? blocks_[2 * i] : blocks_[count_ + i];
      if (joins) blocks_[i] += blocks_[2 * i + 1];
    }
    if (joins) block_s_ *= 2;
    whole_ = whole_ && joins;
  }

  double longest_s_;
  double block_s_ = 0.25;
  bool whole_ = true;
  ScoreBlock<n> open_;
  std::size_t count_ = 0;
  std::array<ScoreBlock<n>, 48> blocks_;
};

/// How much noise there is, as it counts for the parameters.
///
/// Residuals of real recordings hang together for tenths of a second (friction, ripple, filters),
/// so that a hundred samples may tell no more than one; an interval from their variance alone is
/// too narrow. What counts is the variance of sums over blocks that are long against that. Along a
/// direction v of the parameters
///   R = sum_blocks (v's)^2 / sum_blocks (v'A v - v'A P A v)
/// with P the covariance for a noise of variance 1: the second term is what the estimate has taken
/// up of the block itself. For white noise R is its variance; in any case R P_ii is the variance of
/// x_i where v = P e_i/P_ii, which makes v'phi the part of regressor i that the others leave over
/// (batch means: P. Carlstein, Ann. Statist. 14, 1986, on the scores of W. Newey and K. West,
/// Econometrica 55, 1987).
class LongRunVariance {
 public:
  template <int n>
  void add(const ScoreBlock<n>& block, const std::type_identity_t<Eigen::Vector<double, n>>& v,
           const std::type_identity_t<Eigen::Vector<double, n>>& x,
           const std::type_identity_t<Eigen::Matrix<double, n, n>>& P) {
    if (block.is_rest()) return;  // what little it says is said with small weights
    const Eigen::Vector<double, n> Av = block.A * v;
    const double score = v.dot(block.g - block.A * x);
    const double expected = v.dot(Av) - Av.dot(P * Av);
    if (!(expected > 0)) return;
    square_ += score * score;
    expected_ += expected;
    expected2_ += expected * expected;
  }

  double value() const { return expected_ > 0 ? square_ / expected_ : 0; }

  /// So many blocks that weigh alike.
  double dof() const { return expected2_ > 0 ? expected_ * expected_ / expected2_ : 0; }

  static constexpr double least_dof = 3;
  bool is_known() const { return dof() >= least_dof && square_ > 0; }

 private:
  double square_ = 0, expected_ = 0, expected2_ = 0;
};

/// One for each parameter.
template <int n>
using LongRunVariances = std::array<LongRunVariance, static_cast<std::size_t>(n)>;

}  // namespace searig::estimator
