// Least squares where some rows hold at any scale.
#pragma once

#include "estimator/diagnosis/fit/regression.h"

namespace searig::estimator {

/// Rows that read 0 = column*g - the rest. They hold at any scale, zero included, so least squares
/// shrinks everything by what their errors weigh; but the errors are those of the column, and count
/// relative to g.
struct FreeScale {
  Eigen::Index column, first_row, rows;
  double reference;  ///< the g for which the rows are whitened
};

/// Minimises |other rows|^2 + (reference/g)^2 |those rows|^2. On return columns and right side are
/// linearised about the solution: those rows carry reference/g, and in them the measured column is
/// replaced by what the rest makes of it, so that ordinary least squares gives the same answer.
/// (A functional relation with errors in one variable; W. Fuller, Measurement Error Models, 1987.)
/// `sd` is that of the linearised problem but for these errors.
Solution solve(Eigen::MatrixXd& columns, Eigen::VectorXd& right, const FreeScale& scale);

}  // namespace searig::estimator
