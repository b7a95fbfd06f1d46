#include "estimator/diagnosis/answer/next_experiment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "estimator/physics/catalogue.h"
#include "tests/estimator/diagnosis/simulated_actuator.h"

namespace searig::estimator {
namespace {

Piece piece(const char* effect, std::vector<double> shape = {}) {
  return {find_effect(effect), std::move(shape), nullptr};
}

class NextExperiment : public testing::Test {
 protected:
  NextExperiment() : bench_(prepare(signals_, 0.01)) {
    truth_ = {piece("spring.linear"), piece("drive.motor"), piece("drive.inertia"),
              piece("spring.viscous")};
    bench_.learn_noise(truth_, {});
    bench_.learn_torque(truth_);
    model_ = rig_.paper();
    model_.set("spring.viscous", "c_nm_s_per_rad", 0.6);
  }

  static SimulatedActuator damped() {
    SimulatedActuator rig;
    rig.viscous = 0.6;
    return rig;
  }

  const SimulatedActuator rig_ = damped();
  const Signals signals_ = rig_.record();
  Bench bench_;
  Hypothesis truth_;
  Model model_;
};

TEST_F(NextExperiment, TellsNothingFromItself) {
  const auto choice = Rehearsal(bench_, truth_, model_).best_against({truth_});
  ASSERT_TRUE(choice);
  EXPECT_LT(choice->deviance, 5.0);
}

TEST_F(NextExperiment, MovesFastToShowADamper) {
  Hypothesis without = truth_;
  without.pop_back();
  const auto choice = Rehearsal(bench_, truth_, model_).best_against({without});
  ASSERT_TRUE(choice);
  EXPECT_GT(choice->deviance, 100.0);
  EXPECT_GT(*std::ranges::max_element(choice->motion.frequencies_hz), 0.5)
      << words_for(choice->motion);
}

TEST_F(NextExperiment, ProposesNothingWithoutRivals) {
  EXPECT_FALSE(Rehearsal(bench_, truth_, model_).best_against({}));
}

TEST_F(NextExperiment, AsksForNoMoreThanTheRigHasShown) {
  const Motion& seen = bench_.experiment().motion;
  double largest = 0.0;
  for (const double theta : seen.theta) largest = std::max(largest, std::abs(theta));
  for (const PlannedMotion& motion : motion_library(seen)) {
    for (const double theta : angles_of(motion, 100.0).deflection_rad)
      ASSERT_LE(std::abs(theta), 1.6 * largest) << words_for(motion);
  }
}

}  // namespace
}  // namespace searig::estimator
