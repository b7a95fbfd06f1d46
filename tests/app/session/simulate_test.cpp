#include "app/session/simulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "app/session/motion_spec.h"
#include "estimator/model/predict.h"
#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::app {
namespace {

const char* const kSpec = R"(
format = "searig-spec/1"
[model.spring.linear]
k_nm_per_rad = 40.0
[model.spring.viscous]
c_nm_s_per_rad = 0.5
[model.drive.motor]
torque_constant_nm_per_a = 2.5
efficiency = 0.8
[model.drive.coulomb]
torque_nm = 0.2
smoothing_rad_s = 0.01
[motion]
kind = "triangle"
seconds = 20.0
amplitudes_rad = [0.1, 0.2]
frequencies_hz = [0.5]
output_rad = 0.3
[rates]
module_hz = 200.0
loadcell_hz = 25.0
)";

MotionSpec spec_of(const std::string& text) {
  const TemporaryFolder folder;
  return read_motion_spec(folder.write("spec.toml", text));
}

TEST(Simulate, MakesTheMotionOfASpec) {
  const auto recording = recording_of(spec_of(kSpec));
  EXPECT_EQ(recording.module.t_s.size(), 4001u);
  EXPECT_EQ(recording.loadcell.t_s.size(), 501u);
  const auto& q_i = recording.module.channel("input_angle_rad");
  const auto& q_o = recording.module.channel("output_angle_rad");
  double first = 0.0, second = 0.0;
  for (std::size_t i = 0; i < q_i.size(); ++i) {
    double& largest = recording.module.t_s[i] < 9.9 ? first : second;
    largest = std::max(largest, std::abs(q_i[i] - q_o[i]));
  }
  EXPECT_NEAR(first, 0.1, 0.005);
  EXPECT_NEAR(second, 0.2, 0.01);
}

TEST(Simulate, GivesTorqueAndCurrentThatFitTheModel) {
  const MotionSpec spec = spec_of(kSpec);
  const Session like = session_of(recording_of(spec));
  const Session simulated = session_of(simulate(spec.model, like, {}).recording);
  const auto torques = estimator::predict(spec.model, simulated.signals.module);
  for (std::size_t i = 0; i < torques.drive_nm.size(); ++i)
    ASSERT_NEAR(torques.drive_nm[i], torques.spring_nm[i], 1e-6);
  const auto expected = estimator::sample_at(simulated.signals.module.t_s, torques.loadcell_nm,
                                             simulated.signals.loadcell.t_s);
  for (std::size_t i = 0; i < expected.size(); ++i)
    ASSERT_NEAR(simulated.signals.loadcell.torque_nm[i], expected[i], 1e-9);
}

TEST(Simulate, RepeatsItsNoise) {
  const MotionSpec spec = spec_of(kSpec);
  const Session like = session_of(recording_of(spec));
  const SimulatedNoise noise{0.02, 0.01, 7};
  const auto a = simulate(spec.model, like, noise), b = simulate(spec.model, like, noise);
  const auto clean = simulate(spec.model, like, {});
  const auto& x = a.recording.loadcell.channel("torque_nm");
  EXPECT_EQ(x, b.recording.loadcell.channel("torque_nm"));
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    sum += std::pow(x[i] - clean.recording.loadcell.channel("torque_nm")[i], 2);
  EXPECT_NEAR(std::sqrt(sum / double(x.size())), 0.02, 0.002);
}

TEST(Simulate, SaysWhereThereIsNoCurrent) {
  MotionSpec spec = spec_of(kSpec);
  std::erase_if(spec.model.terms, [](const auto& t) { return t.effect.starts_with("drive."); });
  const auto simulated = simulate(spec.model, session_of(recording_of(spec)), {});
  EXPECT_TRUE(simulated.recording.module.channel("current_a").empty());
  ASSERT_EQ(simulated.notes.size(), 1u);
}

TEST(MotionSpec, RefusesWhatItDoesNotKnow) {
  const std::string text = kSpec;
  const auto refusal = [](const std::string& words) -> std::string {
    try {
      spec_of(words);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string out = text;
    return out.replace(out.find(from), from.size(), to);
  };
  EXPECT_NE(refusal(with("seconds", "secnds")).find("line 15: there is no secnds"),
            std::string::npos)
      << refusal(with("seconds", "secnds"));
  EXPECT_NE(refusal(with("triangle", "square")).find("kind must be"), std::string::npos);
  EXPECT_NE(refusal(with("[0.5]", "[]")).find("frequencies_hz must be numbers"), std::string::npos);
  EXPECT_NE(refusal(with("searig-spec/1", "other")).find("format must be"), std::string::npos);
  EXPECT_NE(refusal(with("spring.viscous", "spring.magic"))
                .find("line 5: no effect is called [spring.magic]"),
            std::string::npos);
}

}  // namespace
}  // namespace searig::app
