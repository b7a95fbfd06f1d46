#include "estimator/model/model.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace searig::estimator {
namespace {

const std::string contracts_example = R"(format = "searig-model/1"
[spring.linear]
k_nm_per_rad = 40.0
[drive.motor]
torque_constant_nm_per_a = 2.6   # at the gear output: motor constant times gear ratio
efficiency = 0.75
[drive.inertia]
j_kg_m2 = 0.012                  # sum of J_i r_i, at the gear output
[drive.coulomb]
torque_nm = 0.25
smoothing_rad_s = 0.01
[drive.viscous]
b_nm_s_per_rad = 0.15
)";

std::string refusal(const std::string& text) {
  try {
    parse_model(text, "model.toml");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "not refused";
}

std::string with_format(const std::string& rest) {
  return "format = \"searig-model/1\"\n" + rest;
}

TEST(Model, ReadsTheContractsExample) {
  const Model m = parse_model(contracts_example, "model.toml");
  EXPECT_EQ(m.terms.size(), 5u);
  EXPECT_EQ(m.get("spring.linear", "k_nm_per_rad"), 40.0);
  EXPECT_EQ(m.get("drive.motor", "efficiency"), 0.75);
  EXPECT_EQ(m.get("drive.coulomb", "smoothing_rad_s"), 0.01);
  EXPECT_FALSE(m.has("spring.viscous"));
  EXPECT_EQ(m.get("spring.viscous", "c_nm_s_per_rad"), std::nullopt);
  EXPECT_EQ(m.get("spring.linear", "c_nm_s_per_rad"), std::nullopt);
}

TEST(Model, TakesWholeNumbers) {
  const Model m = parse_model(with_format("[spring.linear]\nk_nm_per_rad = 40\n"), "model.toml");
  EXPECT_EQ(m.get("spring.linear", "k_nm_per_rad"), 40.0);
}

TEST(Model, ComesBackExactlyFromItsText) {
  Model m;
  m.set("spring.linear", "k_nm_per_rad", 0.1 + 0.2);
  m.set("drive.motor", "torque_constant_nm_per_a", 1.0);
  m.set("drive.motor", "efficiency", 1.0 / 3.0);
  m.set("rig.zero_drift", "nm_per_min", -1e-17);
  m.set("spring.cubic", "k3_nm_per_rad3", 6.02214076e23);
  const Model back = parse_model(to_toml(m), "model.toml");
  ASSERT_EQ(back.terms.size(), m.terms.size());
  for (const auto& term : m.terms) {
    ASSERT_TRUE(back.has(term.effect)) << term.effect;
    EXPECT_EQ(back.find(term.effect)->parameters, term.parameters) << term.effect;
  }
  EXPECT_EQ(to_toml(parse_model(to_toml(back), "model.toml")), to_toml(back));
}

TEST(Model, MayHaveNoTermAtAll) {
  EXPECT_TRUE(parse_model(with_format(""), "model.toml").terms.empty());
}

TEST(Model, SetsChangesAndAddsWithoutDoubling) {
  Model m;
  m.set("spring.linear", "k_nm_per_rad", 1);
  m.set("spring.linear", "k_nm_per_rad", 2);
  EXPECT_EQ(m.terms.size(), 1u);
  EXPECT_EQ(m.get("spring.linear", "k_nm_per_rad"), 2.0);
}

TEST(Model, SaysWhatIsWrongWithFileLineAndTerm) {
  EXPECT_EQ(refusal(with_format("[spring.lineal]\nk_nm_per_rad = 1\n")),
            "model.toml: line 2: no effect is called [spring.lineal]");
  EXPECT_EQ(refusal(with_format("[spring.linear]\nk = 1\n")),
            "model.toml: line 3: [spring.linear] has no parameter k");
  EXPECT_EQ(refusal(with_format("\n[drive.motor]\nefficiency = 1\n")),
            "model.toml: line 3: [drive.motor] lacks torque_constant_nm_per_a");
  EXPECT_EQ(refusal(with_format("[spring.linear]\nk_nm_per_rad = \"40\"\n")),
            "model.toml: line 3: [spring.linear] k_nm_per_rad must be a finite number");
  EXPECT_EQ(refusal(with_format("[spring.linear]\nk_nm_per_rad = nan\n")),
            "model.toml: line 3: [spring.linear] k_nm_per_rad must be a finite number");
  EXPECT_EQ(refusal(with_format("[drive.motor]\ntorque_constant_nm_per_a = 2\nefficiency = 1.4\n")),
            "model.toml: line 4: [drive.motor] efficiency = 1.4 is outside 0.0 to 1.0");
  EXPECT_EQ(refusal(with_format("[spring.relaxation]\nk1_nm_per_rad = 2\ntau_s = 1\ntau2_s = 3\n")),
            "model.toml: line 2: [spring.relaxation] has tau2_s but no k2_nm_per_rad");
  EXPECT_EQ(refusal(with_format("spring = 3\n")),
            "model.toml: line 2: spring is not a group of effects");
  EXPECT_EQ(refusal(with_format("[spring]\nlinear = 40\n")),
            "model.toml: line 3: spring.linear is not a table of parameters");
}

TEST(Model, SaysWhatIsNoModelAtAll) {
  const std::string wrong_format = "model.toml: format must be \"searig-model/1\"";
  EXPECT_EQ(refusal(""), wrong_format);
  EXPECT_EQ(refusal("format = \"searig-recording/1\"\n"), wrong_format);
  EXPECT_EQ(refusal("format = 1\n"), wrong_format);
  EXPECT_EQ(refusal("format = \"searig-model/1\"\n[spring.linear\n").find("model.toml: line 2: "),
            0u);
}

}  // namespace
}  // namespace searig::estimator
