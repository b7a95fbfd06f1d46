#include "app/session/merge.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace searig::app {
namespace {

/// Ten seconds from `start_s` on, the load cell a little longer than the module.
Session ten_seconds(const std::string& name, double start_s, bool with_current) {
  Session session;
  session.recording.name = name;
  for (int i = 0; i <= 100; ++i) {
    session.signals.module.t_s.push_back(start_s + 0.1 * i);
    session.signals.module.deflection_rad.push_back(start_s);
    if (with_current) session.signals.module.current_a.push_back(1.0);
  }
  for (int i = -5; i <= 55; ++i) {
    session.signals.loadcell.t_s.push_back(start_s + 0.2 * i);
    session.signals.loadcell.torque_nm.push_back(start_s);
  }
  session.signals.clock_ci95_s = 1e-3 * start_s;
  return session;
}

TEST(Merge, LeavesOneRecordingAsItIs) {
  const Session session = ten_seconds("a", 5.0, true);
  const Merged merged = merge({&session});
  EXPECT_EQ(merged.signals.module.t_s, session.signals.module.t_s);
  ASSERT_EQ(merged.parts.size(), 1u);
  EXPECT_EQ(merged.parts[0].from_s, 5.0);
  EXPECT_EQ(merged.parts[0].to_s, 15.0);
}

TEST(Merge, PutsOneBehindTheOtherWithAGap) {
  const Session a = ten_seconds("a", 5.0, true), b = ten_seconds("b", 2.0, true);
  const Merged merged = merge({&a, &b});
  const auto& t = merged.signals.module.t_s;
  ASSERT_EQ(t.size(), 202u);
  EXPECT_DOUBLE_EQ(t[0], 0.0);
  EXPECT_NEAR(t[101] - t[100], gap_between_s, 1e-9);
  EXPECT_EQ(merged.parts[1].name, "b");
  EXPECT_NEAR(merged.parts[1].from_s, 30.0, 1e-9);
  EXPECT_EQ(merged.signals.clock_ci95_s, 5e-3);
  // What the load cell measured beyond the module's own time is left out.
  for (std::size_t i = 0; i < merged.signals.loadcell.t_s.size(); ++i) {
    const double s = merged.signals.loadcell.t_s[i];
    EXPECT_TRUE(s < 10.01 || s > 29.99) << s;
    EXPECT_EQ(merged.signals.loadcell.torque_nm[i], s < 20.0 ? 5.0 : 2.0);
  }
}

TEST(Merge, LeavesOutWhatNotAllHaveAndSaysSo) {
  const Session a = ten_seconds("a", 5.0, true), b = ten_seconds("b", 2.0, false);
  const Merged merged = merge({&a, &b});
  EXPECT_TRUE(merged.signals.module.current_a.empty());
  EXPECT_EQ(merged.signals.module.deflection_rad.size(), 202u);
  ASSERT_EQ(merged.notes.size(), 1u);
  EXPECT_EQ(merged.notes[0], "current_a is left out: b does not have it");
}

TEST(Merge, RefusesAnEmptyRecording) {
  const Session a = ten_seconds("a", 5.0, true), empty;
  EXPECT_THROW(merge({&a, &empty}), std::invalid_argument);
}

}  // namespace
}  // namespace searig::app
