// States by the names of the model file: regressors from the catalogue, parameters with intervals.
#include "estimator/filter/spring_states.h"

#include <gtest/gtest.h>

#include <cmath>

namespace searig::estimator {
namespace {

Motion two_samples() {
  Motion m;
  m.t = {0, 0.01};
  m.theta = {0.1, 0.2};
  m.theta_rate = {3, 4};
  m.spring_c = {25, 35};
  return m;
}

TEST(SpringStates, TakeTheirRegressorsFromTheCatalogue) {
  const SpringStates states(
      {"spring.linear", "spring.viscous", "spring.cubic", "spring.temperature", "spring.mullins"});
  const Eigen::MatrixXd phi = states.regressors(two_samples());
  EXPECT_DOUBLE_EQ(phi(1, 0), 0.2);       // theta, (1)
  EXPECT_DOUBLE_EQ(phi(1, 1), 4);         // theta', (12)
  EXPECT_DOUBLE_EQ(phi(1, 2), 0.008);     // theta^3
  EXPECT_DOUBLE_EQ(phi(1, 3), 0.2 * 10);  // theta (c - 25)
  EXPECT_DOUBLE_EQ(phi(1, 4), -0.2);      // what is lost of k
}

TEST(SpringStates, KnowTheMaxwellBranchByItsTime) {
  const SpringStates given({"spring.linear", "spring.relaxation:0.5"});
  Model model;
  model.terms = {{"spring.relaxation", {{"k1_nm_per_rad", 3}, {"tau_s", 0.5}}}};
  const SpringStates from_model({"spring.linear", "spring.relaxation"}, &model);
  const Motion m = two_samples();
  EXPECT_EQ(given.regressors(m), from_model.regressors(m));
  EXPECT_NEAR(given.regressors(m)(1, 1), 0.1, 0.01);  // nothing has relaxed in 10 ms
}

TEST(SpringStates, ParametersAreTheModelFiles) {
  const SpringStates states({"spring.linear", "spring.temperature"});
  const Eigen::Vector2d x(50, 0.25), dof(10, 20);
  const Eigen::Matrix2d P = Eigen::Vector2d(4, 0.01).asDiagonal();
  const auto p = states.parameters(x, P, dof);
  ASSERT_EQ(p.size(), 2u);
  EXPECT_EQ(p[0].name, "k_nm_per_rad");
  EXPECT_NEAR(p[0].sd, 2, 1e-6);
  EXPECT_EQ(p[1].name, "per_c");
  EXPECT_DOUBLE_EQ(p[1].value, 0.25 / 50);
  EXPECT_NEAR(p[1].sd, std::hypot(0.1 / 50, 0.25 / 2500 * 2), 1e-7);  // of a quotient
  EXPECT_EQ(p[1].dof, 20);
}

TEST(SpringStates, SayTheStiffnessNowWhereItSoftens) {
  const SpringStates states({"spring.linear", "spring.mullins"});
  Eigen::Matrix2d P;
  P << 4, 3.5, 3.5, 4;
  const auto p = states.parameters(Eigen::Vector2d(50, 10), P, Eigen::Vector2d(9, 9));
  ASSERT_EQ(p.size(), 3u);
  EXPECT_DOUBLE_EQ(p[1].value, 0.2);  // share
  EXPECT_EQ(p[2].name, "k_now_nm_per_rad");
  EXPECT_DOUBLE_EQ(p[2].value, 40);
  EXPECT_NEAR(p[2].sd, 1, 1e-4);  // sqrt(4 + 4 - 7)
}

TEST(SpringStates, RefuseWithOneSentence) {
  const auto complaint = [](const std::vector<std::string>& names) -> std::string {
    try {
      SpringStates{names};
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(complaint({}), "");
  EXPECT_NE(complaint({"spring.viscous"}), "");
  EXPECT_NE(complaint({"spring.linear", "spring.linear"}), "");
  EXPECT_NE(complaint({"spring.linear", "spring.wobble"}), "");
  EXPECT_NE(complaint({"spring.linear", "drive.coulomb"}), "");
  EXPECT_NE(complaint({"spring.linear", "spring.deadzone"}), "");
  EXPECT_NE(complaint({"spring.linear", "spring.relaxation"}).find("tau_s"), std::string::npos);
  EXPECT_NE(complaint({"spring.linear", "spring.relaxation:0"}), "");
  EXPECT_NE(complaint({"spring.linear", "spring.relaxation:x"}), "");
  EXPECT_NE(complaint({"spring.linear", "spring.viscous:1"}), "");
  EXPECT_EQ(complaint({"spring.linear", "spring.asymmetry"}), "");
}

TEST(SpringStates, SayWhichChannelIsMissing) {
  Motion m = two_samples();
  m.spring_c.clear();
  EXPECT_EQ(SpringStates({"spring.linear", "spring.temperature"}).lacks(m), "spring_temperature_c");
  EXPECT_EQ(SpringStates({"spring.linear", "spring.mullins"}).lacks(m), "");
}

}  // namespace
}  // namespace searig::estimator
