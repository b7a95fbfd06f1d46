// Least squares on whitened rows: solutions, what a further column would gain, and blocks held out.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace searig::estimator {

struct Solution {
  Eigen::VectorXd coefficients;
  Eigen::VectorXd residual;
  double sse = 0.0;
  Eigen::VectorXd sd;  ///< of the coefficients, for unit noise
};

/// Scaled normal equations with one step of refinement; a column of zeros gets the coefficient 0.
Solution solve(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right);

/// A fixed set of columns that candidates are held against.
class Projection {
 public:
  Projection(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right);

  struct Gain {
    double sse = 0.0;              ///< fall of the sum of squares
    Eigen::VectorXd coefficients;  ///< of the candidate's columns
    double independence = 0.0;     ///< share of the candidate that the fixed columns do not span
  };
  Gain gain(const Eigen::MatrixXd& candidate) const;
  /// What of the candidate the fixed columns do not span.
  Eigen::MatrixXd free_part(const Eigen::MatrixXd& candidate) const {
    return candidate - basis_ * (basis_.transpose() * candidate);
  }
  const Eigen::VectorXd& residual() const { return residual_; }
  double sse() const { return residual_.squaredNorm(); }

 private:
  Eigen::MatrixXd basis_;
  Eigen::VectorXd residual_;
};

/// Sum of squares over all blocks, each predicted by a fit that did not see it. Rows of block -1
/// (priors) take part in every fit and are not scored. `each` gets the sum per block.
double heldout_sse(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right,
                   const std::vector<int>& block, std::vector<double>* each = nullptr);

}  // namespace searig::estimator
