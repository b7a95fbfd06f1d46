// The estimator on the simulated Arduino against the same header on the host, and against the
// host's own filter: 60 s at 1 kHz. Prints what a sample costs on the AVR.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "arduino/board/estimator_on_board.h"
#include "estimator/filter/paper_models.h"
#include "estimator/filter/size.h"
#include "estimator/filter/ssukf.h"

namespace searig::board {
namespace {

using estimator::FirmwareSettings;
using estimator::FirmwareStiffness;

constexpr float k = 50;
constexpr int samples = 60'000;  // at 1 kHz

struct Recorded {
  float deflection, drive;
};

// A spring of 50 N*m/rad moved by two sines, with the noise of encoders and current.
std::vector<Recorded> minute() {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Recorded> out;
  for (int i = 0; i < samples; ++i) {
    const double t = 1e-3 * i;
    const double theta = 0.06 * std::sin(3.1 * t) + 0.03 * std::sin(5.3 * t);
    out.push_back({static_cast<float>(theta + 1e-4 * normal(random)),
                   static_cast<float>(k * theta + 0.05 * normal(random))});
  }
  return out;
}

// As the host scales the paper's numbers to this size; a start ten times too high.
FirmwareSettings settings() {
  const estimator::Size size{
      .torque_nm = 2, .deflection_rad = 0.04, .deflection_rate_rad_s = 0.16, .step_s = 0.001};
  const auto units = estimator::PaperUnits{estimator::paper_gamma_rad2_per_s,
                                           estimator::paper_alpha, estimator::paper_beta}
                         .scaled_to(size);
  const auto number = [](double x) { return static_cast<float>(x); };
  return {10 * k,
          100,
          100,
          number(units.gamma),
          number(units.alpha),
          number(units.beta),
          number(size.step_s)};
}

TEST(EstimatorOnBoard, AgreesWithTheHostOverAMinuteAndHoldsAKilohertz) {
  EstimatorOnBoard board(SEARIG_ESTIMATOR_ELF, settings());
  FirmwareStiffness<> host(settings());
  double largest = 0, cycles = 0;
  std::uint64_t most = 0;
  for (const Recorded& s : minute()) {
    const EstimatorStep step = board.push(s.deflection, s.drive);
    host.push(s.deflection, s.drive);
    largest = std::max(largest, std::abs(step.k_nm_per_rad / double(host.k_nm_per_rad()) - 1));
    most = std::max(most, step.cycles);
    cycles += static_cast<double>(step.cycles) / samples;
  }
  std::printf(
      "AVR: %.0f cycles per sample in the mean, %llu at most, of 16000 at 1 kHz; "
      "k %.4f, largest relative difference from the host %.2g\n",
      cycles, static_cast<unsigned long long>(most), double(host.k_nm_per_rad()), largest);
  EXPECT_LT(most, 16'000u);
  EXPECT_LT(largest, 1e-4);
  EXPECT_NEAR(host.k_nm_per_rad(), k, 0.01 * k);
}

// The header's steps are those of the filter that the paper names, to what a float holds.
TEST(FirmwareStiffness, IsThePapersFilterInFloat) {
  const FirmwareSettings s = settings();
  FirmwareStiffness<> firmware(s);
  using One = Eigen::Vector<double, 1>;
  std::optional<estimator::Ssukf<1>> filter;
  filter.emplace(One(s.initial_k), One(s.initial_variance));
  constexpr int half = 16;
  const auto recorded = minute();
  double largest = 0;
  for (int i = 0; i < samples; ++i) {
    firmware.push(recorded[i].deflection, recorded[i].drive);
    if (i < 2 * half) continue;
    const Recorded& centre = recorded[i - half];
    const double before = filter->state()(0), w = firmware.weight();
    const double Q = std::min(s.alpha * before, s.largest_variance - filter->covariance()(0));
    ASSERT_TRUE(filter->predict(One(std::max(0.0, Q))));
    const auto error = [&](const One& x) {
      return w * std::pow(double(centre.drive) - x(0) * centre.deflection, 2);
    };
    ASSERT_TRUE(filter->update(error, 0.0, s.beta));
    filter->set_state(One(std::clamp(filter->state()(0), before / 10, before * 10)));
    largest = std::max(largest, std::abs(firmware.k_nm_per_rad() / filter->state()(0) - 1));
  }
  std::printf("largest relative difference from the filter in double: %.2g\n", largest);
  EXPECT_LT(largest, 1e-3);
}

TEST(FirmwareStiffness, TrustsWhatTheHostTrusts) {
  FirmwareStiffness<> firmware(settings());
  const auto recorded = minute();
  for (int i = 0; i < 5000; ++i) {
    firmware.push(recorded[i].deflection, recorded[i].drive);
    const double t = 1e-3 * (i - 16);
    const double theta = 0.06 * std::sin(3.1 * t) + 0.03 * std::sin(5.3 * t);
    const double rate = 0.186 * std::cos(3.1 * t) + 0.159 * std::cos(5.3 * t);
    if (i > 100) {
      ASSERT_NEAR(firmware.weight(), estimator::trust_weight(theta, rate, settings().gamma), 0.15);
    }
  }
}

}  // namespace
}  // namespace searig::board
