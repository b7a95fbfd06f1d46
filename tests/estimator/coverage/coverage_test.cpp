// Honest intervals: over 200 seeds each holds the truth in 90 to 98 of 100. Prints what it finds:
//   ctest --preset release -L long -R Coverage --verbose
#include "tests/estimator/coverage/coverage.h"

#include <gtest/gtest.h>

#include "tests/estimator/coverage/offered.h"

namespace searig::estimator {
namespace {

constexpr int seeds = 200;

class Coverage : public testing::TestWithParam<Offered> {};

TEST_P(Coverage, Is90To98Percent) {
  const Offered& offered = GetParam();
  const auto covered = coverage(offered.springs, offered.kind, seeds);
  print(offered.name(), covered);
  for (const auto& [name, c] : covered) {
    EXPECT_GE(c.percent(), 90) << name;
    EXPECT_LE(c.percent(), 98) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Offered, Coverage, testing::ValuesIn(offered_sets()),
                         [](const auto& one) { return "Set" + std::to_string(one.index); });

}  // namespace
}  // namespace searig::estimator
