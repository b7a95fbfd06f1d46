#include "estimator/physics/observation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made_motion.h"

namespace searig::estimator {
namespace {

struct Tone {
  std::vector<double> t;
  Eigen::VectorXd x;
};

/// Unevenly sampled sine of 3 rad/s.
Tone tone() {
  const int n = 20000;
  Tone out{std::vector<double>(n), Eigen::VectorXd(n)};
  for (int i = 0; i < n; ++i) {
    out.t[std::size_t(i)] = 0.001 * i + 0.0003 * std::sin(0.9 * i);
    out.x[i] = std::sin(3 * out.t[std::size_t(i)]);
  }
  return out;
}

Eigen::VectorXd seen(const char* effect, const Tone& s, double seconds) {
  return dynamic_cast<const Observation*>(find_effect(effect))->seen(s.t, s.x, seconds);
}

TEST(Lag, WeakensAndDelaysASineAsAFirstOrderLowPass) {
  const Tone s = tone();
  for (const double tau : {0.01, 0.1, 0.5}) {
    const Eigen::VectorXd y = seen("rig.lag", s, tau);
    const double gain = 1 / std::hypot(1, 3 * tau), phase = std::atan(3 * tau);
    for (int i = 10000; i < y.size(); ++i)  // once it has settled
      ASSERT_NEAR(y[i], gain * std::sin(3 * s.t[std::size_t(i)] - phase), 1e-6) << tau;
  }
}

TEST(Lag, LeavesAConstantAndNoLagLeavesAnything) {
  Tone s = tone();
  EXPECT_LT((seen("rig.lag", s, 1e-12) - s.x).cwiseAbs().maxCoeff(), 1e-9);
  s.x.setConstant(3.5);
  EXPECT_LT((seen("rig.lag", s, 0.3).array() - 3.5).abs().maxCoeff(), 1e-12);
}

TEST(Delay, ReadsWhatWasThereThen) {
  const Tone s = tone();
  for (const double delay : {0.0, 0.0123, 0.4, -0.02}) {
    const Eigen::VectorXd y = seen("rig.delay", s, delay);
    for (int i = 500; i < y.size() - 500; ++i)
      ASSERT_NEAR(y[i], std::sin(3 * (s.t[std::size_t(i)] - delay)), 3e-6) << delay;
  }
}

TEST(Delay, HoldsTheFirstAndTheLastSampleBeyondTheRecording) {
  const Tone s = tone();
  EXPECT_EQ(seen("rig.delay", s, 0.4)[0], s.x[0]);
  EXPECT_EQ(seen("rig.delay", s, 0.4)[300], s.x[0]);
  EXPECT_EQ(seen("rig.delay", s, -0.4)[s.x.size() - 1], s.x[s.x.size() - 1]);
}

TEST(Observations, AddNoTorqueOfTheirOwn) {
  const Motion motion = hand_made_motion();
  for (const char* name : {"rig.delay", "rig.lag"}) {
    const Effect& effect = *find_effect(name);
    EXPECT_EQ(effect.path(), Path::observation);
    EXPECT_EQ(effect.features(motion, std::vector<double>{0.01}).cols(), 0);
  }
}

}  // namespace
}  // namespace searig::estimator
