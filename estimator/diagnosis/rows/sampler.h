// Signals on the module's samples, averaged over windows around other times.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace searig::estimator {

/// Averages a signal over [centre - width/2, centre + width/2]. Between samples it is straight;
/// where samples are further apart than the window is wide it is a cubic whose slopes at the
/// samples are those of the parabolas through three (Catmull-Rom): straight lines are short of a
/// curve's peaks, which looks like physics. Both sides of a comparison go through the same window,
/// so that a filter is never mistaken for physics.
class Sampler {
 public:
  Sampler() = default;
  Sampler(const std::vector<double>& t, const std::vector<double>& centres, double width_s,
          double shift_s = 0.0);

  Eigen::Index rows() const { return Eigen::Index(begin_.size()); }

  /// Windows that reach beyond the signal, or across a hole of more than `gap_s` in it.
  std::vector<bool> covered(double gap_s) const;

  /// x: one value per module sample; returns one value per centre.
  Eigen::VectorXd operator()(const Eigen::VectorXd& x) const;
  Eigen::MatrixXd columns(const Eigen::MatrixXd& x) const;

 private:
  struct Place {
    Eigen::Index sample;  // the interval that the time is in
    double within_s;      // from its beginning
  };
  using Slopes = Eigen::MatrixX2d;  // at the beginning and end of each interval
  Slopes slopes(const Eigen::VectorXd& x) const;
  double integral_to(const Place& place, const Eigen::VectorXd& x, const Slopes& slope,
                     const Eigen::VectorXd& integral) const;

  Eigen::VectorXd t_;
  bool curved_ = false;
  std::vector<Place> begin_, end_;
  std::vector<bool> inside_;
};

}  // namespace searig::estimator
