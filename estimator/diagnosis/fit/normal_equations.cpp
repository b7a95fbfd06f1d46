#include "estimator/diagnosis/fit/normal_equations.h"

namespace searig::estimator {

Eigen::VectorXd inverse_norms(const Eigen::MatrixXd& columns) {
  Eigen::VectorXd out = columns.colwise().norm();
  for (double& n : out) n = n > 0 ? 1.0 / n : 0.0;
  return out;
}

Eigen::LDLT<Eigen::MatrixXd> factors(Eigen::MatrixXd normal) {
  for (double& d : normal.diagonal()) d = d > 0 ? d + 1e-11 : 1.0;
  return Eigen::LDLT<Eigen::MatrixXd>(normal);
}

Eigen::MatrixXd product(const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
  out.selfadjointView<Eigen::Lower>().rankUpdate(columns.transpose());
  return out.selfadjointView<Eigen::Lower>();
}

Eigen::VectorXd deviations(const Eigen::LDLT<Eigen::MatrixXd>& normal) {
  const Eigen::MatrixXd inverse =
      normal.solve(Eigen::MatrixXd::Identity(normal.rows(), normal.rows()));
  return inverse.diagonal().cwiseMax(0.0).cwiseSqrt();
}

}  // namespace searig::estimator
