#include "app/report/quantity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "estimator/physics/catalogue.h"

namespace searig::app {
namespace {

TEST(Quantity, SplitsNameAndUnit) {
  EXPECT_EQ(label_of("c_nm_s_per_rad"), "c (N·m·s/rad)");
  EXPECT_EQ(label_of("deflection_rate_rad_s"), "deflection rate (rad/s)");
  EXPECT_EQ(label_of("input_acceleration_rad_s2"), "input acceleration (rad/s²)");
  EXPECT_EQ(label_of("time_since_reversal_s"), "time since reversal (s)");
  EXPECT_EQ(label_of("share"), "share");
}

/// A unit that is not known would end up as a word of the name.
TEST(Quantity, KnowsTheUnitsOfTheWholeCatalogue) {
  for (const auto* effect : estimator::catalogue()) {
    for (const auto& p : effect->parameters()) {
      const std::string name = quantity_of(p.name).name;
      for (const char* unit : {" rad", " nm", " kg"})
        EXPECT_EQ(name.find(unit), std::string::npos) << effect->name() << " " << p.name;
    }
  }
}

TEST(Quantity, WritesFigures) {
  EXPECT_EQ(figures(0.0123456), "0.0123");
  EXPECT_EQ(figures(-42.0), "−42.0");
  EXPECT_EQ(figures(0.09996), "0.100");
  EXPECT_EQ(figures(2761570.0), "2.76e6");
  EXPECT_EQ(figures(0.0), "0");
  EXPECT_EQ(figures(INFINITY), "–");
}

TEST(Quantity, GivesAsManyDigitsAsTheIntervalDeserves) {
  const Rounded r = rounded(2.38299, 2.3813, 2.3847);
  EXPECT_EQ(r.value, "2.3830");
  EXPECT_EQ(r.lower, "2.3813");
  EXPECT_EQ(r.upper, "2.3847");
  EXPECT_EQ(rounded(0.714, 0.714, 0.714).value, "0.714");
}

}  // namespace
}  // namespace searig::app
