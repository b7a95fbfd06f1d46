#include "estimator/filter/online_stiffness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <new>

#include "tests/estimator/filter/hand_made.h"

namespace searig::estimator {
bool counting_allocations = false;  // of this whole test program
int counted_allocations = 0;
}  // namespace searig::estimator

void* operator new(std::size_t size) {
  using namespace searig::estimator;
  if (counting_allocations) ++counted_allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace searig::estimator {
namespace {

std::vector<OnlineEstimate> run(const HandMade& signals, const OnlineOptions& options) {
  OnlineStiffness online(options);
  std::vector<OnlineEstimate> out;
  for (std::size_t i = 0; i < signals.t.size(); ++i) {
    EXPECT_TRUE(online.push(signals.t[i], signals.theta[i], signals.drive[i]));
    while (const auto estimate = online.next()) out.push_back(*estimate);
  }
  return out;
}

double last_k(const HandMade& signals, const OnlineOptions& options) {
  return run(signals, options).back().k_nm_per_rad;
}

TEST(OnlineStiffness, FindsTheStiffnessFromATenfoldWrongStart) {
  HandMade signals;
  signals.make(20);
  for (const double factor : {0.1, 0.5, 1.0, 2.0, 10.0}) {
    EXPECT_NEAR(last_k(signals, {.initial_k_nm_per_rad = factor * 50}), 50, 0.5) << factor;
  }
}

TEST(OnlineStiffness, FindsItWithThePapersOwnNumbers) {
  HandMade signals;
  signals.make(60);
  for (const double factor : {0.1, 1.0, 10.0}) {
    EXPECT_NEAR(last_k(signals, exactly_as_the_paper(factor * 50)), 50, 0.5) << factor;
  }
}

// Springs of 2 to 3,000 N*m/rad, torques of 0.3 to 60 N*m, slow and fast, 100 Hz to 1 kHz.
TEST(OnlineStiffness, FindsTheStiffnessAtEverySize) {
  for (const double k : {2.0, 50.0, 400.0, 3000.0}) {
    for (const double torque : {0.3, 5.0, 60.0}) {
      for (const double rate_hz : {100.0, 1000.0}) {
        HandMade signals{.k = k, .amplitude = torque / k, .speed = 0.5, .rate_hz = rate_hz};
        signals.make(20);
        for (const double factor : {0.1, 10.0}) {
          EXPECT_NEAR(last_k(signals, {.initial_k_nm_per_rad = factor * k}) / k, 1, 0.01)
              << k << " N*m/rad, " << torque << " N*m, " << rate_hz << " Hz, start x" << factor;
        }
      }
    }
  }
}

// The size is learnt from the stream, so a scaled module is the same module to the last digits.
TEST(OnlineStiffness, DoesNotKnowOfUnits) {
  HandMade small{.k = 50, .amplitude = 0.08}, large{.k = 50 * 64, .amplitude = 0.08 / 4};
  small.make(10), large.make(10);
  const auto a = run(small, {.initial_k_nm_per_rad = 500});
  const auto b = run(large, {.initial_k_nm_per_rad = 500 * 64});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_NEAR(b[i].k_nm_per_rad / 64 / a[i].k_nm_per_rad, 1, 1e-6);
    ASSERT_NEAR(b[i].weight, a[i].weight, 1e-6);
  }
}

// Stiction and backlash make the drive torque a false witness while the deflection shrinks. With
// friction that the drive model lacks, the trusted half of the motion reads high, the other half
// low: a weight of the wrong sign would end on the other side.
TEST(OnlineStiffness, TrustsTheDriveOnlyWhileTheDeflectionGrows) {
  HandMade signals{.friction = 0.1};
  signals.make(30);
  const double k = last_k(signals, {.initial_k_nm_per_rad = 50});
  EXPECT_GT(k, 52);
  EXPECT_LT(k, 65);
}

// Without Q the estimate would freeze; with it, a softened spring is followed.
TEST(OnlineStiffness, FollowsASpringThatSoftens) {
  HandMade stiff{.k = 50}, soft{.k = 35, .rest_s = 0};
  stiff.make(60), soft.make(30, 2);
  for (std::size_t i = 0; i < soft.t.size(); ++i) {
    stiff.t.push_back(60 + soft.t[i]);
    stiff.theta.push_back(soft.theta[i]);
    stiff.drive.push_back(soft.drive[i]);
  }
  EXPECT_NEAR(last_k(stiff, {.initial_k_nm_per_rad = 50}), 35, 0.7);
  OnlineOptions without_q{.initial_k_nm_per_rad = 50};
  without_q.paper.alpha = 1e-12;
  EXPECT_GT(last_k(stiff, without_q), 36.5);
}

TEST(OnlineStiffness, StepsOnSeveralSamplesAtOnce) {
  HandMade signals;
  signals.make(60);
  EXPECT_NEAR(last_k(signals, {.initial_k_nm_per_rad = 100, .samples_per_step = 5}), 50, 1);
}

TEST(OnlineStiffness, WaitsForMotion) {
  HandMade signals{.rest_s = 5};
  signals.make(8);
  for (const auto& estimate : run(signals, {.initial_k_nm_per_rad = 500})) {
    if (estimate.t_s > 5) break;
    EXPECT_EQ(estimate.weight, 0);
    EXPECT_EQ(estimate.k_nm_per_rad, 500);
  }
}

TEST(OnlineStiffness, SaysTheTorqueOfItsOwnSample) {
  HandMade signals;
  const auto estimates = run(signals.make(5), {.initial_k_nm_per_rad = 60});
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    ASSERT_EQ(estimates[i].t_s, signals.t[i]);
    ASSERT_EQ(estimates[i].deflection_rad, signals.theta[i]);
    ASSERT_EQ(estimates[i].drive_nm, signals.drive[i]);
    ASSERT_EQ(estimates[i].torque_nm, estimates[i].k_nm_per_rad * signals.theta[i]);
  }
}

// A drive torque of the wrong sign, or one that is all noise, has no stiffness above 0 to offer.
TEST(OnlineStiffness, StaysPositiveAndFiniteWhateverComes) {
  for (const double k : {-50.0, 0.0, 1e12}) {
    HandMade signals{.k = k == 0 ? 50 : k, .noise = k == 0 ? 10.0 : 0.01};
    for (const auto& estimate : run(signals.make(20), {.initial_k_nm_per_rad = 50})) {
      ASSERT_TRUE(std::isfinite(estimate.k_nm_per_rad)) << k;
      ASSERT_GT(estimate.k_nm_per_rad, 0) << k;
    }
  }
  for (const double broken : {std::nan(""), HUGE_VAL}) {
    OnlineStiffness online({.initial_k_nm_per_rad = 50});
    EXPECT_FALSE(online.push(1, broken, 1));
    EXPECT_FALSE(online.push(1, 1, broken));
    EXPECT_FALSE(online.push(broken, 1, 1));
  }
}

TEST(OnlineStiffness, GetsOverGarbledSamples) {
  HandMade signals;
  signals.make(60);
  for (std::size_t i = 1000; i + 500 < signals.drive.size() / 2; i += 1000) {
    signals.drive[i] = 100;  // N*m, of 4
    signals.theta[i + 500] = -1;
  }
  EXPECT_NEAR(last_k(signals, {.initial_k_nm_per_rad = 50}), 50, 0.5);
}

TEST(OnlineStiffness, StaysFiniteWithNumbersThatNoSensorHas) {
  for (const double garbled : {1e150, 1e300}) {
    HandMade signals;
    signals.make(20);
    signals.drive[1000] = garbled;
    signals.theta[2000] = -garbled;
    for (const auto& estimate : run(signals, {.initial_k_nm_per_rad = 50})) {
      ASSERT_TRUE(std::isfinite(estimate.k_nm_per_rad));
      ASSERT_GT(estimate.k_nm_per_rad, 0);
    }
  }
}

TEST(OnlineStiffness, RefusesOptionsThatMakeNoSense) {
  EXPECT_THROW(OnlineStiffness({.initial_k_nm_per_rad = 0}), std::invalid_argument);
  EXPECT_THROW(OnlineStiffness({.initial_k_nm_per_rad = -3}), std::invalid_argument);
  EXPECT_THROW(OnlineStiffness({.initial_k_nm_per_rad = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(OnlineStiffness({.initial_k_nm_per_rad = 1, .initial_relative_sd = 0}),
               std::invalid_argument);
  EXPECT_THROW(OnlineStiffness({.initial_k_nm_per_rad = 1, .samples_per_step = 0}),
               std::invalid_argument);
}

TEST(OnlineStiffness, NeverAllocatesAfterConstruction) {
  HandMade signals;
  signals.make(20);
  OnlineStiffness online({.initial_k_nm_per_rad = 500, .samples_per_step = 3});
  Eigen::internal::set_is_malloc_allowed(false);
  counted_allocations = 0, counting_allocations = true;
  double k = 0;
  for (std::size_t i = 0; i < signals.t.size(); ++i) {
    online.push(signals.t[i], signals.theta[i], signals.drive[i]);
    while (const auto estimate = online.next()) k = estimate->k_nm_per_rad;
  }
  counting_allocations = false;
  Eigen::internal::set_is_malloc_allowed(true);
  EXPECT_EQ(counted_allocations, 0);
  EXPECT_NEAR(k, 50, 5);
}

}  // namespace
}  // namespace searig::estimator
