// Several states over a recording; and a short version of tests/estimator/coverage.
#include "estimator/evaluation/state_track.h"

#include <gtest/gtest.h>

#include "tests/estimator/coverage/offered.h"

namespace searig::estimator {
namespace {

TEST(StateTrack, IntervalsHoldTheTruthInMostOf24Seeds) {
  for (const Offered& offered : offered_sets()) {
    for (const auto& [name, c] : coverage(offered.springs, offered.kind, 24, 1000)) {
      EXPECT_GE(c.held, 19) << offered.name() << ": " << name;  // 23 expected; 1 in 200 is below 20
    }
  }
}

// A spring that stands still, hardly any noise, and a filter that expects it to wander: the blocks
// say that there is less than no noise, and still the filter must not follow every sample.
TEST(StateTrack, LinearIsNotMisledByASpringThatStandsStill) {
  const Springs springs{.states = {"spring.linear"}, .white = 0.003, .coloured = 0.003};
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const SimulatedSpring spring = SpringSimulation(springs, seed).run();
    const StateTrack track =
        track_states(spring.module, spring.drive_nm, EstimatorKind::linear,
                     SpringStates(springs.states), {.initial_k_nm_per_rad = 100});
    const double k = spring.truth.at("k_nm_per_rad");
    const StateParameter& found = track.parameters[0];
    EXPECT_NEAR(found.value, k, std::max(0.002 * k, 1.5 * found.half_width_95())) << seed;
    EXPECT_GT(found.half_width_95(), 0.0005 * k) << seed;
    EXPECT_LT(found.half_width_95(), 0.02 * k) << seed;
  }
}

// White noise is what an interval is usually made for; noise that hangs together is what there is.
// The same noise power makes the interval several times wider, and it should.
TEST(StateTrack, IntervalsAreWiderWhereNoiseHangsTogether) {
  const auto half_width = [](double white, double coloured) {
    const Springs springs{.states = {"spring.linear"}, .white = white, .coloured = coloured};
    return coverage(springs, EstimatorKind::rls, 8).at("k_nm_per_rad").half_width;
  };
  EXPECT_GT(half_width(0, 0.05), 3 * half_width(0.05, 0));
}

TEST(StateTrack, SaysWhichChannelAStateNeeds) {
  SimulatedSpring spring = SpringSimulation({.states = {}, .seconds = 2}, 1).run();
  spring.module.spring_temperature_c.clear();
  EXPECT_THROW(track_states(spring.module, spring.drive_nm, EstimatorKind::rls,
                            SpringStates({"spring.linear", "spring.temperature"}),
                            {.initial_k_nm_per_rad = 50}),
               std::invalid_argument);
}

TEST(StateTrack, TorqueIsWhatTheStatesSay) {
  const SimulatedSpring spring = SpringSimulation({.states = {}, .seconds = 5}, 1).run();
  const StateTrack track =
      track_states(spring.module, spring.drive_nm, EstimatorKind::paper,
                   SpringStates({"spring.linear"}), {.initial_k_nm_per_rad = 50});
  ASSERT_EQ(track.torque_nm.size(), spring.module.t_s.size());
  for (std::size_t i = 0; i < track.torque_nm.size(); ++i) {
    const double k = track.x(static_cast<Eigen::Index>(i), 0);
    ASSERT_NEAR(track.torque_nm[i], k * spring.module.deflection_rad[i], 0.001 * k);
  }
}

// A spring that is left alone gets stiffer again, and no data are needed to expect it.
TEST(StateTrack, LossRecoversAtRest) {
  Springs springs{.states = {"spring.linear", "spring.mullins"}, .seconds = 120};
  springs.rest_from_s = 60, springs.rest_to_s = 120;
  springs.softening_share = 0.5;
  const SimulatedSpring spring = SpringSimulation(springs, 4).run();
  const StateTrack track =
      track_states(spring.module, spring.drive_nm, EstimatorKind::linear,
                   SpringStates(springs.states), {.initial_k_nm_per_rad = 50, .recovery_s = 30});
  const double at_60 = track.x(60 * 200, 1), at_90 = track.x(90 * 200, 1);
  ASSERT_GT(std::abs(at_60), 0.5);
  EXPECT_NEAR(at_90 / at_60, std::exp(-1), 0.15);
}

}  // namespace
}  // namespace searig::estimator
