#include "estimator/physics/catalogue.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace searig::estimator {
namespace {

/// The contract's table: what outside users write into model files.
const std::map<std::string, std::vector<std::string>> contract = {
    {"spring.linear", {"k_nm_per_rad"}},
    {"spring.viscous", {"c_nm_s_per_rad"}},
    {"spring.cubic", {"k3_nm_per_rad3"}},
    {"spring.hysteresis", {"torque_nm", "yield_rad"}},
    {"spring.relaxation", {"k1_nm_per_rad", "tau_s", "k2_nm_per_rad", "tau2_s"}},
    {"spring.mullins", {"share", "scale"}},
    {"spring.temperature", {"per_c", "reference_c"}},
    {"spring.asymmetry", {"share"}},
    {"spring.deadzone", {"half_width_rad"}},
    {"drive.motor", {"torque_constant_nm_per_a", "efficiency"}},
    {"drive.inertia", {"j_kg_m2"}},
    {"drive.coulomb", {"torque_nm", "smoothing_rad_s"}},
    {"drive.viscous", {"b_nm_s_per_rad"}},
    {"drive.stribeck", {"torque_nm", "velocity_rad_s"}},
    {"drive.load_friction", {"share"}},
    {"drive.ripple", {"torque_nm", "cycles_per_rad", "phase_rad"}},
    {"drive.current_offset", {"offset_a"}},
    {"drive.torque_constant_temperature", {"per_c", "reference_c"}},
    {"rig.delay", {"delay_s"}},
    {"rig.lag", {"tau_s"}},
    {"rig.zero_drift", {"nm_per_min"}},
    {"rig.gravity", {"torque_nm", "phase_rad"}},
    {"rig.inertia", {"j_kg_m2"}}};

TEST(Catalogue, HasEveryEffectOfTheContractWithItsParameters) {
  for (const auto& [name, parameters] : contract) {
    const Effect* effect = find_effect(name);
    ASSERT_NE(effect, nullptr) << name;
    for (const auto& parameter : parameters)
      EXPECT_TRUE(effect->has_parameter(parameter)) << name << " " << parameter;
  }
}

TEST(Catalogue, AsksForNothingThatTheContractDoesNotName) {
  for (const Effect* effect : catalogue()) {
    if (!contract.contains(effect->name())) continue;
    const auto& named = contract.at(effect->name());
    const std::set<std::string> known(named.begin(), named.end());
    for (const auto& p : effect->parameters())
      EXPECT_TRUE(p.fallback || known.contains(p.name)) << effect->name() << " needs " << p.name;
  }
}

TEST(Catalogue, NamesEachEffectOnceAndPutsItOnThePathThatItsNameSays) {
  std::set<std::string> seen;
  for (const Effect* effect : catalogue()) {
    EXPECT_TRUE(seen.insert(effect->name()).second) << effect->name();
    const std::string group = effect->name().substr(0, effect->name().find('.'));
    const bool fits = effect->path() == Path::spring  ? group == "spring"
                      : effect->path() == Path::drive ? group == "drive"
                                                      : group == "rig";
    EXPECT_TRUE(fits) << effect->name();
  }
}

TEST(Catalogue, TellsAPersonWhatEachEffectIsAndHowToSeparateIt) {
  const std::set<std::string> given{"spring.linear", "drive.motor"};  // nobody looks for these
  for (const Effect* effect : catalogue()) {
    const Description& about = effect->about();
    EXPECT_FALSE(about.title.empty() || about.equation.empty() || about.looks_like.empty() ||
                 about.channel.empty() || about.source.empty())
        << about.name;
    EXPECT_EQ(about.separated_by.empty(), given.contains(about.name)) << about.name;
    for (const auto& p : effect->parameters()) {
      EXPECT_FALSE(p.meaning.empty()) << about.name << " " << p.name;
      EXPECT_LT(p.lower, p.upper) << about.name << " " << p.name;
    }
  }
}

TEST(Catalogue, KnowsNothingThatIsNotInIt) {
  EXPECT_EQ(find_effect("spring"), nullptr);
  EXPECT_EQ(find_effect("spring.cubi"), nullptr);
  EXPECT_EQ(find_effect(""), nullptr);
}

}  // namespace
}  // namespace searig::estimator
