#include "app/rig/link.h"

#include <gtest/gtest.h>

namespace searig::app {
namespace {

TEST(Link, StampsByTheDevicesOwnClock) {
  const LinkSettings settings{{-300.0, 62.25}, 50.0, 0.001, 0.001, 0.0, 1e-6};
  Link link(settings, 1);
  for (int i = 1; i <= 500; ++i, link.advance()) {
    const auto& passage = link.next();
    // Even by the device's clock, whatever that clock is worth.
    EXPECT_NEAR(passage.device_s, 62.25 + 0.02 * i, 1e-6);
    EXPECT_NEAR(passage.device_s, settings.clock.at(passage.taken_s), 1e-6);
  }
}

TEST(Link, NothingArrivesEarlyOrOvertakes) {
  Link link({{0.0, 0.0}, 1000.0, 0.002, 0.005, 0.0, 1e-6}, 2);
  double last = 0.0;
  for (int i = 0; i < 10000; ++i, link.advance()) {
    EXPECT_GE(link.next().arrival_s, link.next().taken_s + 0.002);
    EXPECT_GT(link.next().arrival_s, last);
    last = link.next().arrival_s;
  }
}

TEST(Link, LosesTheStatedShare) {
  Link link({{0.0, 0.0}, 1000.0, 0.001, 0.001, 0.02, 1e-6}, 3);
  int lost = 0;
  for (int i = 0; i < 50000; ++i, link.advance()) lost += link.next().lost ? 1 : 0;
  EXPECT_NEAR(lost, 1000, 130);  // four standard deviations
}

}  // namespace
}  // namespace searig::app
