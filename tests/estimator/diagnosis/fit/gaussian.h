// Seeded noise for tests.
#pragma once

#include <Eigen/Core>
#include <random>

namespace searig::estimator {

inline Eigen::MatrixXd gaussian(Eigen::Index rows, Eigen::Index cols, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return gauss(random); });
}

}  // namespace searig::estimator
