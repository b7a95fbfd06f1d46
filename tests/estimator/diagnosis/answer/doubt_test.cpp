#include "estimator/diagnosis/answer/doubt.h"

#include <gtest/gtest.h>

#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

TEST(Doubt, WhatIsTakenBackStaysOpenBesideItsRivals) {
  Account account;
  account.final.hypothesis.push_back({find_effect("spring.relaxation"), {1.0}, nullptr});
  account.assessments.emplace_back();
  Diagnosis out;
  Finding f;
  f.effect = "spring.relaxation", f.probability = 0.3;
  f.alternatives = {{"", 0.5, ""}, {"spring.viscous", 0.2, ""}};
  out.findings.push_back(f);
  withdraw_contradicted(account, out);
  EXPECT_TRUE(out.findings.empty());
  ASSERT_TRUE(out.unexplained);
  ASSERT_EQ(out.undecidable.size(), 1u);
  EXPECT_EQ(out.undecidable[0].effects,
            (std::vector<std::string>{"spring.relaxation", "spring.viscous"}));
}

}  // namespace
}  // namespace searig::estimator
