#include "app/rig/simulated_rig.h"

#include <gtest/gtest.h>

#include <cmath>

#include "estimator/model/predict.h"

namespace searig::app {
namespace {

const acquisition::Recording& one_minute() {
  static const SimulatedRig rig = [] {
    SimulatedRig made;
    made.run_until(60.0);
    return made;
  }();
  return rig.recording();
}

TEST(SimulatedRig, DoesNotDependOnHowTimeIsCut) {
  SimulatedRig whole, pieces;
  whole.run_until(3.0);
  for (double t = 0.0; t < 3.0; t += 0.0137) pieces.run_until(t);
  pieces.run_until(3.0);
  for (const auto& [a, b] :
       {std::pair(&whole.recording().module, &pieces.recording().module),
        std::pair(&whole.recording().loadcell, &pieces.recording().loadcell)}) {
    EXPECT_EQ(a->t_s, b->t_s);
    EXPECT_EQ(a->host_s, b->host_s);
    ASSERT_EQ(a->channels.size(), b->channels.size());
    for (std::size_t i = 0; i < a->channels.size(); ++i) {
      EXPECT_EQ(a->channels[i].values, b->channels[i].values);
    }
  }
}

TEST(SimulatedRig, ModuleAt500HzAndLoadCellAt50Hz) {
  const auto& recording = one_minute();
  EXPECT_NEAR(recording.module.t_s.size(), 30000, 5);
  EXPECT_NEAR(recording.loadcell.t_s.size() + recording.loadcell.counts.lost, 3000, 3);
  EXPECT_EQ(recording.module.counts.received, recording.module.t_s.size());
}

TEST(SimulatedRig, ClocksAreFoundAsTheyAre) {
  SimulatedRig rig;
  rig.run_until(60.0);
  const auto found = acquisition::synchronise(rig.recording());
  const auto truth = rig.true_clock_map();
  EXPECT_TRUE(found.trusted) << found.why;
  EXPECT_NEAR(found.rate, truth.rate, 3e-6);
  const double middle_s = rig.recording().loadcell.t_s[1500];
  EXPECT_NEAR(found.to_module(middle_s), truth.to_module(middle_s), found.ci95_s);
  EXPECT_LT(found.ci95_s, 0.005);
}

// With both clocks undone, the load cell reads k*theta: the largest departure is the friction-free
// rubber's own loss, not a shift in time.
TEST(SimulatedRig, LoadCellReadsTheSpring) {
  RigSettings settings;
  settings.parameters.spring.softening_share = 0.0;
  settings.parameters.spring.branches.clear();
  SimulatedRig rig(settings);
  rig.run_until(20.0);
  const auto& module = rig.recording().module;
  std::vector<double> theta(module.t_s.size());
  for (std::size_t i = 0; i < theta.size(); ++i) {
    theta[i] = module.channels[0].values[i] - module.channels[1].values[i];
  }
  const auto map = rig.true_clock_map();
  const auto& loadcell = rig.recording().loadcell;
  std::vector<double> t_s;
  for (const double t : loadcell.t_s) t_s.push_back(map.to_module(t));
  const auto expected = estimator::sample_at(module.t_s, theta, t_s);
  double square = 0.0, size = 0.0;
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    const double torque = loadcell.channels[0].values[i] * rig.recording().lever_arm_m;
    square += std::pow(torque - 40.0 * expected[i], 2);
    size += std::pow(torque, 2);
  }
  EXPECT_LT(std::sqrt(square / size), 0.01);
  EXPECT_GT(std::sqrt(size / static_cast<double>(t_s.size())), 1.5);  // and it is a real load
}

}  // namespace
}  // namespace searig::app
