#include "app/rig/live_rig.h"

#include <gtest/gtest.h>

#include "estimator/model/predict.h"

namespace searig::app {
namespace {

TEST(LiveRig, FollowsTheStiffnessFromTenTimesTooHigh) {
  LiveRig rig;
  for (double t = 0.0; t <= 30.0; t += 0.033) rig.run_until(t);
  const auto& history = rig.history();
  EXPECT_GT(history.stiffness_nm_per_rad.front(), 350.0);
  const double truth = rig.rig().true_stiffness_nm_per_rad();
  EXPECT_NEAR(history.stiffness_nm_per_rad.back(), truth, 0.06 * truth);
  EXPECT_LT(*error_percent(history, 10.0), 5.0);
  EXPECT_TRUE(rig.clock().trusted);
}

TEST(LiveRig, ShowsTheSameHoweverOftenItIsCalled) {
  LiveRig often, seldom;
  for (double t = 0.0; t < 8.0; t += 0.01) often.run_until(t);
  for (double t = 0.0; t < 8.0; t += 0.5) seldom.run_until(t);
  often.run_until(8.0);
  seldom.run_until(8.0);
  const auto &a = often.history(), &b = seldom.history();
  ASSERT_EQ(a.t_s, b.t_s);
  ASSERT_GT(a.t_s.size(), 3800u);
  EXPECT_EQ(a.weight, b.weight);
  for (std::size_t i = 0; i < a.t_s.size(); i += 50) {
    EXPECT_NEAR(a.stiffness_nm_per_rad[i], b.stiffness_nm_per_rad[i], 1e-6);
    EXPECT_NEAR(a.current_nm[i], b.current_nm[i], 1e-9);
  }
}

TEST(LiveRig, HistoryIsThatOfTheWholeRecording) {
  LiveRig rig;
  for (double t = 0.0; t <= 15.0; t += 0.033) rig.run_until(t);
  const auto& recording = rig.recording();
  const auto& history = rig.history();
  EXPECT_EQ(history.measured_t_s.size(), recording.loadcell.t_s.size());
  EXPECT_GT(history.t_s.back(), 14.8);  // at most a fifth of a second behind
  EXPECT_LE(history.t_s.size(), recording.module.t_s.size());
}

TEST(History, ErrorIsThePapers) {
  History history;
  history.t_s = {0, 1, 2, 3};
  history.estimated_nm = {1, 1, 1, 1};
  history.measured_t_s = {0.5, 1.5, 2.5, 9.0};  // the last has no estimate beside it
  history.measured_nm = {2, -2, 1, 100};
  EXPECT_DOUBLE_EQ(*error_percent(history), 100.0 * (1 + 3 + 0) / 5);
  EXPECT_DOUBLE_EQ(*error_percent(history, 1.0), 100.0 * 3 / 3);
  EXPECT_FALSE(error_percent(History{}).has_value());
}

}  // namespace
}  // namespace searig::app
