#include "estimator/twin/paper_module.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace searig::estimator::twin {
namespace {

TEST(PaperModule, SpringsDifferAsThePaperSays) {
  const double nominal = nominal_paper_module().spring.stiffness_nm_per_rad;
  double least = nominal, most = nominal;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const auto spring = paper_module(seed).spring;
    least = std::min(least, spring.stiffness_nm_per_rad);
    most = std::max(most, spring.stiffness_nm_per_rad);
    EXPECT_GE(spring.worn_at_start, 0.0);
    EXPECT_LT(spring.worn_at_start, 1.0);
    // The whole rubber is stiffer, not only what stays.
    EXPECT_NEAR(spring.branches[0].stiffness_nm_per_rad / spring.stiffness_nm_per_rad, 0.15, 1e-9);
  }
  EXPECT_NEAR(least, 0.9 * nominal, 0.005 * nominal);
  EXPECT_NEAR(most, 1.1 * nominal, 0.005 * nominal);
  EXPECT_EQ(paper_module(7).spring.worn_at_start, paper_module(7).spring.worn_at_start);
}

TEST(PaperModule, EveryNumberHasASourceOrAReason) {
  for (const Fact& fact : paper_module_facts()) {
    EXPECT_FALSE(fact.what.empty() || fact.value.empty());
    EXPECT_FALSE(fact.source.empty() && fact.reason.empty()) << fact.what;
  }
}

}  // namespace
}  // namespace searig::estimator::twin
