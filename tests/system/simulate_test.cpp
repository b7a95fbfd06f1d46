// searig simulate and searig diagnose against each other: what a model has and the simulation that
// is held against it lacks must be named, and nothing where they are the same.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/system/run_program.h"
#include "tests/temporary_folder.h"

namespace searig {
namespace {

const std::string kBase = R"(format = "searig-model/1"
[spring.linear]
k_nm_per_rad = 40.0
[drive.motor]
torque_constant_nm_per_a = 2.6
efficiency = 0.75
[drive.inertia]
j_kg_m2 = 0.012
[drive.coulomb]
torque_nm = 0.25
smoothing_rad_s = 0.01
[drive.viscous]
b_nm_s_per_rad = 0.15
)";

/// A motion with slow and fast parts, small and large, as one recording whose torques come later.
std::string motion_spec(const std::string& model_file) {
  return "format = \"searig-spec/1\"\nmodel = \"" + model_file + R"("
[motion]
kind = "multisine"
seconds = 60.0
amplitudes_rad = [0.08, 0.2, 0.05, 0.15]
frequencies_hz = [0.3, 1.0, 2.0]
output_rad = 0.5
[noise]
loadcell_nm = 0.01
current_a = 0.01
seed = 5
)";
}

nlohmann::json diagnosis(const std::string& arguments) {
  const Ran ran = run_program("searig diagnose " + arguments + " --json -");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  return nlohmann::json::parse(ran.out);
}

std::set<std::string> names(const nlohmann::json& answer) {
  std::set<std::string> out;
  for (const auto& finding : answer.at("findings")) out.insert(finding.at("effect"));
  return out;
}

struct Missing {
  const char* effect;
  const char* term;
};

void PrintTo(const Missing& missing, std::ostream* out) {
  *out << missing.effect;
}

class SimulateCommand : public testing::TestWithParam<Missing> {};

TEST_P(SimulateCommand, MakesWhatDiagnoseNames) {
  const TemporaryFolder folder;
  const std::string in = folder.path().string() + "/";
  folder.write("base.toml", kBase);
  folder.write("truth.toml", kBase + GetParam().term);
  folder.write("spec.toml", motion_spec("truth.toml"));
  const Ran ran = run_program("searig simulate " + in + "spec.toml --out " + in + "made");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;

  const auto own = diagnosis(in + "made");
  EXPECT_EQ(own.at("verdict"), "consistent");
  EXPECT_EQ(names(own), std::set<std::string>());

  const auto without =
      diagnosis(in + "made --model " + in + "base.toml --write-model " + in + "found.toml");
  EXPECT_EQ(without.at("verdict"), "missing_physics");
  EXPECT_EQ(names(without), std::set<std::string>{GetParam().effect});

  EXPECT_EQ(diagnosis(in + "made --model " + in + "found.toml").at("verdict"), "consistent");
}

INSTANTIATE_TEST_SUITE_P(
    Effects, SimulateCommand,
    testing::Values(
        Missing{"spring.viscous", "[spring.viscous]\nc_nm_s_per_rad = 0.5\n"},
        Missing{"spring.hysteresis", "[spring.hysteresis]\ntorque_nm = 0.2\nyield_rad = 0.01\n"},
        Missing{"drive.ripple",
                "[drive.ripple]\ntorque_nm = 0.15\ncycles_per_rad = 24.0\nphase_rad = 0.4\n"},
        Missing{"rig.zero_drift", "[rig.zero_drift]\nnm_per_min = 0.2\n"}),
    [](const auto& each) {
      std::string name = each.param.effect;
      name[name.find('.')] = '_';
      return name;
    });

TEST(SimulateLike, TakesMotionAndClocksFromARecording) {
  const TemporaryFolder folder;
  const std::string in = folder.path().string() + "/";
  folder.write("base.toml", kBase);
  folder.write("spec.toml", motion_spec("base.toml"));
  ASSERT_EQ(run_program("searig simulate " + in + "spec.toml --out " + in + "first").exit_code, 0);
  folder.write("cubic.toml", kBase + "[spring.cubic]\nk3_nm_per_rad3 = 500.0\n");
  const Ran ran = run_program("searig simulate " + in + "cubic.toml --like " + in + "first --out " +
                              in + "second --noise-nm 0.01 --noise-a 0.01 --seed 2");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(names(diagnosis(in + "second --model " + in + "base.toml")),
            std::set<std::string>{"spring.cubic"});
  EXPECT_EQ(run_program("searig simulate " + in + "cubic.toml --like " + in + "first --out " + in +
                        "first")
                .exit_code,
            1);
}

TEST(SimulateUse, IsTold) {
  EXPECT_EQ(run_program("searig simulate").exit_code, 2);
  EXPECT_EQ(run_program("searig simulate nowhere.toml --out /tmp/x").exit_code, 1);
  EXPECT_EQ(run_program("searig simulate m.toml --out /tmp/x --noise-nm 1").exit_code, 2);
  const Ran help = run_program("searig simulate --help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("kind = "), std::string::npos);
}

}  // namespace
}  // namespace searig
