// What every least-squares solver here does with its columns: scale, multiply, factorise.
#pragma once

#include <Eigen/Dense>

namespace searig::estimator {

/// One over each column's norm; 0 for a column of zeros.
Eigen::VectorXd inverse_norms(const Eigen::MatrixXd& columns);

/// columns' * columns.
Eigen::MatrixXd product(const Eigen::MatrixXd& columns);

/// Cholesky factors of the scaled normal equations; a trace of ridge carries columns that others
/// span, and columns of zeros get a one on the diagonal.
Eigen::LDLT<Eigen::MatrixXd> factors(Eigen::MatrixXd normal);

/// Standard deviations of the coefficients, for unit noise.
Eigen::VectorXd deviations(const Eigen::LDLT<Eigen::MatrixXd>& normal);

}  // namespace searig::estimator
