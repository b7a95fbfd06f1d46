// The model file's numbers -> amplitudes and shape -> the model file's numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "hand_made_motion.h"

namespace searig::estimator {
namespace {

const std::vector<Term> terms = {
    {"spring.linear", {{"k_nm_per_rad", 40}}},
    {"spring.viscous", {{"c_nm_s_per_rad", 0.7}}},
    {"spring.cubic", {{"k3_nm_per_rad3", -90}}},
    {"spring.hysteresis", {{"torque_nm", 0.3}, {"yield_rad", 0.02}}},
    {"spring.relaxation",
     {{"k1_nm_per_rad", 9}, {"tau_s", 0.4}, {"k2_nm_per_rad", 4}, {"tau2_s", 6}}},
    {"spring.mullins", {{"share", 0.1}, {"scale", 2}, {"history", 1}}},
    {"spring.temperature", {{"per_c", -0.004}, {"reference_c", 21}}},
    {"spring.asymmetry", {{"share", -0.2}}},
    {"spring.deadzone", {{"half_width_rad", 0.01}}},
    {"drive.motor", {{"torque_constant_nm_per_a", 2.6}, {"efficiency", 0.75}}},
    {"drive.inertia", {{"j_kg_m2", 0.03}}},
    {"drive.coulomb", {{"torque_nm", 0.3}, {"smoothing_rad_s", 0.02}}},
    {"drive.viscous", {{"b_nm_s_per_rad", 0.2}}},
    {"drive.stribeck", {{"torque_nm", 0.3}, {"velocity_rad_s", 0.1}}},
    {"drive.load_friction", {{"share", 0.1}, {"backdriving_ratio", 1.5}}},
    {"drive.ripple",
     {{"torque_nm", 0.2},
      {"cycles_per_rad", 12},
      {"phase_rad", -2.5},
      {"torque2_nm", 0.1},
      {"cycles2_per_rad", 40},
      {"phase2_rad", 1.5}}},
    {"drive.current_offset", {{"offset_a", -0.05}}},
    {"drive.torque_constant_temperature", {{"per_c", -0.002}, {"reference_c", 25}}},
    {"rig.delay", {{"delay_s", 0.02}}},
    {"rig.lag", {{"tau_s", 0.03}}},
    {"rig.zero_drift", {{"nm_per_min", -0.3}}},
    {"rig.gravity", {{"torque_nm", 1.5}, {"phase_rad", 0.4}}},
    {"rig.inertia", {{"j_kg_m2", 0.02}}}};

TEST(Term, ComesBackFromItsAmplitudesAndShape) {
  const Motion motion = hand_made_motion();
  const Model model = hand_made_model();
  for (const Term& term : terms) {
    const Effect& effect = *find_effect(term.effect);
    const Term back =
        effect.term(effect.amplitudes(term, model), effect.shape(term), model, motion);
    EXPECT_EQ(back.effect, term.effect);
    ASSERT_EQ(back.parameters.size(), term.parameters.size()) << term.effect;
    for (const auto& [name, value] : term.parameters)
      EXPECT_NEAR(back.parameters.at(name), value, 1e-12) << term.effect << " " << name;
  }
}

TEST(Term, IsTriedForEveryEffectThereIs) {
  std::set<std::string> tried;
  for (const Term& term : terms) tried.insert(term.effect);
  for (const Effect* effect : catalogue()) EXPECT_TRUE(tried.contains(effect->name()));
}

TEST(Features, HaveOneColumnPerAmplitudeAtEveryShapeOfTheGrid) {
  const Motion motion = hand_made_motion();
  const Model model = hand_made_model();
  for (const Effect* effect : catalogue()) {
    if (effect->path() == Path::observation) continue;
    const auto grid = effect->shape_grid(motion);
    ASSERT_FALSE(grid.empty()) << effect->name();
    for (const auto& shape : grid) {
      EXPECT_LE(effect->free_shape(shape), shape.size()) << effect->name();
      const Eigen::MatrixXd features = effect->features(motion, shape);
      ASSERT_EQ(features.rows(), Eigen::Index(motion.size())) << effect->name();
      ASSERT_TRUE(features.allFinite()) << effect->name();
      const Eigen::VectorXd ones = Eigen::VectorXd::Ones(features.cols());
      const Term term = effect->term(ones, shape, model, motion);
      if (!effect->tied_to().empty()) continue;
      EXPECT_LT((effect->amplitudes(term, model) - ones).cwiseAbs().maxCoeff(), 1e-12)
          << effect->name();
    }
  }
}

TEST(Grid, StaysWithinTheRangeThatAShapeMayBePolishedIn) {
  const Motion motion = hand_made_motion();
  for (const Effect* effect : catalogue())
    for (const auto& shape : effect->shape_grid(motion))
      for (std::size_t i = 0; i < effect->free_shape(shape); ++i) {
        EXPECT_GE(shape[i], effect->shape_range(motion, shape, i).lower) << effect->name();
        EXPECT_LE(shape[i], effect->shape_range(motion, shape, i).upper) << effect->name();
      }
}

TEST(PhysicalSigns, AreKeptWhereNatureHasOnlyOne) {
  const Eigen::VectorXd plus = Eigen::VectorXd::Ones(1), minus = -plus;
  for (const char* name : {"spring.linear", "spring.viscous", "spring.mullins", "drive.coulomb",
                           "drive.viscous", "drive.stribeck", "drive.inertia", "rig.inertia"}) {
    EXPECT_TRUE(find_effect(name)->physical(plus)) << name;
    EXPECT_FALSE(find_effect(name)->physical(minus)) << name;
  }
  for (const char* name : {"spring.cubic", "spring.temperature", "spring.asymmetry",
                           "drive.current_offset", "rig.zero_drift"})
    EXPECT_TRUE(find_effect(name)->physical(minus)) << name;
}

}  // namespace
}  // namespace searig::estimator
