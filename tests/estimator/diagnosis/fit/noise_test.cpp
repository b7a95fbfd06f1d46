#include "estimator/diagnosis/fit/noise.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

namespace searig::estimator {
namespace {

Eigen::VectorXd autoregressive(Eigen::Index n, double phi1, double phi2, double sd, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss(0.0, sd);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n + 500);
  for (Eigen::Index i = 2; i < x.size(); ++i)
    x[i] = phi1 * x[i - 1] + phi2 * x[i - 2] + gauss(random);
  return x.tail(n);
}

double correlation(const Eigen::VectorXd& x, Eigen::Index lag) {
  return x.head(x.size() - lag).dot(x.tail(x.size() - lag)) / x.squaredNorm();
}

/// Load-cell rows alone, at 50 Hz.
Experiment rows_at_50_hz(Eigen::Index n) {
  Experiment e;
  e.loadcell_nm = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) e.loadcell_t.push_back(0.02 * double(i));
  e.motion.t = e.motion.theta = e.loadcell_t;
  e.usable.assign(std::size_t(n), true);
  e.weight.assign(std::size_t(n), 1.0);
  return e;
}

const std::vector<bool> all(40000, true);

TEST(Autoregression, RecoversAFirstOrderProcess) {
  // A hundredth of the noise is always taken to be white: coefficients shrink by so much.
  for (const double phi : {0.0, 0.5, -0.6, 0.9}) {
    const auto ar = fit_autoregression(autoregressive(40000, phi, 0, 0.3, 1), all, 1);
    EXPECT_NEAR(ar.phi[0], phi / 1.01, 0.015) << phi;
  }
  EXPECT_NEAR(fit_autoregression(autoregressive(40000, 0.5, 0, 0.3, 1), all, 1).sd, 0.3, 0.01);
}

TEST(Autoregression, RecoversASecondOrderProcess) {
  const double phi1 = 0.6, phi2 = -0.5;
  const auto ar = fit_autoregression(autoregressive(40000, phi1, phi2, 0.3, 2), all, 2);
  const double rho1 = phi1 / (1 - phi2), rho2 = phi1 * rho1 + phi2;
  Eigen::Matrix2d toeplitz;
  toeplitz << 1.01, rho1, rho1, 1.01;
  const Eigen::Vector2d expected = toeplitz.inverse() * Eigen::Vector2d(rho1, rho2);
  EXPECT_NEAR(ar.phi[0], expected[0], 0.015);
  EXPECT_NEAR(ar.phi[1], expected[1], 0.015);
  EXPECT_NEAR(expected[0], phi1, 0.06);  // the shrinking is small
}

TEST(Autoregression, LooksOnlyAtUsableRows) {
  Eigen::VectorXd x = autoregressive(40000, 0.5, 0, 0.3, 3);
  std::vector<bool> usable = all;
  for (Eigen::Index i = 0; i < x.size(); i += 50) x[i] = 1e6, usable[std::size_t(i)] = false;
  const auto ar = fit_autoregression(x, usable, 1);
  EXPECT_NEAR(ar.phi[0], 0.5 / 1.01, 0.02);
  EXPECT_NEAR(ar.sd, 0.3, 0.01);
}

TEST(Autoregression, IsNotWidenedByOutliers) {
  Eigen::VectorXd x = autoregressive(40000, 0, 0, 0.3, 4);
  for (Eigen::Index i = 0; i < x.size(); i += 500) x[i] = 5;
  EXPECT_NEAR(fit_autoregression(x, all, 2).sd, 0.3, 0.02);
}

TEST(Autoregression, OfNothingIsWhite) {
  const auto ar = fit_autoregression(Eigen::VectorXd::Zero(100), std::vector<bool>(100, true), 3);
  EXPECT_EQ(ar.phi, Eigen::VectorXd::Zero(3));
  EXPECT_EQ(ar.sd, 1.0);
}

TEST(Whitening, MakesCorrelatedNoiseWhiteWithUnitVariance) {
  for (const double phi : {0.0, 0.6, 0.9}) {
    const Eigen::VectorXd x = autoregressive(20000, phi, 0, 0.3, 5);
    const Whitening whitening(rows_at_50_hz(20000), x);
    const Eigen::VectorXd white = whitening(x).bottomRows(20000 - Whitening::order);
    EXPECT_NEAR(white.squaredNorm() / double(white.size()), 1.0, 0.03) << phi;
    // The hundredth that is taken to be white leaves a little of a long memory in.
    for (Eigen::Index lag = 1; lag <= 20; ++lag)
      EXPECT_NEAR(correlation(white, lag), 0.0, phi > 0.8 ? 0.1 : 0.05) << phi << " lag " << lag;
  }
}

TEST(Whitening, TreatsBothSidesOfAnEquationAlike) {
  const Whitening whitening(rows_at_50_hz(500), autoregressive(500, 0.7, 0, 1, 6));
  const Eigen::MatrixXd x = Eigen::MatrixXd::Random(500, 1), y = Eigen::MatrixXd::Random(500, 1);
  EXPECT_LT((whitening(2 * x - 3 * y) - 2 * whitening(x) + 3 * whitening(y)).norm(), 1e-10);
}

TEST(Whitening, CountsOnlyRowsThatHaveTheirNeighbours) {
  Experiment e = rows_at_50_hz(200);
  e.usable[100] = false;
  for (std::size_t i = 150; i < 200; ++i) e.loadcell_t[i] += 1.0;  // a hole in time
  const Whitening whitening(e, autoregressive(200, 0.5, 0, 1, 7));
  const auto& counts = whitening.counts();
  constexpr std::size_t order = Whitening::order;
  for (std::size_t i = 0; i < 200; ++i) {
    const bool blind = i < order || (i >= 100 && i <= 100 + order) || (i >= 150 && i < 150 + order);
    EXPECT_EQ(counts[i], !blind) << i;
  }
  EXPECT_EQ(whitening.used_rows(), Eigen::Index(200 - order - (order + 1) - order));
  const Eigen::MatrixXd white = whitening(Eigen::MatrixXd::Ones(200, 1));
  EXPECT_EQ(white(100, 0), 0.0);
  EXPECT_NE(white(120, 0), 0.0);
}

TEST(Whitening, LeavesPriorRowsAlone) {
  const Whitening whitening(rows_at_50_hz(200), autoregressive(200, 0.5, 0, 1, 8));
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(203, 1);
  x.bottomRows(3) << 1, 2, 3;
  EXPECT_EQ(whitening(x), x);
}

TEST(SlowShare, IsOneOverTheRowsWhereNoiseIsWhiteAndGrowsWithItsMemory) {
  Autoregression noise{Eigen::VectorXd::Zero(5), 1.0};
  EXPECT_NEAR(slow_share(noise, 50), 0.02, 1e-12);
  // Of a first-order process: (1/n) (1 + 2 sum (1 - k/n) phi^k).
  noise.phi[0] = 0.9;
  double expected = 1.0;
  for (int k = 1; k < 50; ++k) expected += 2.0 * (1.0 - k / 50.0) * std::pow(0.9, k);
  EXPECT_NEAR(slow_share(noise, 50), expected / 50.0, 1e-6);
}

}  // namespace
}  // namespace searig::estimator
