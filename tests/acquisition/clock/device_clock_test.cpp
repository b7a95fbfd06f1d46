#include "acquisition/clock/device_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace searig::acquisition {
namespace {

std::vector<double> ticking(std::size_t rows, double step, double from = 0.0) {
  std::vector<double> t(rows);
  for (std::size_t i = 0; i < rows; ++i) t[i] = from + step * static_cast<double>(i);
  return t;
}

bool rises(const std::vector<double>& t) {
  return std::adjacent_find(t.begin(), t.end(), std::greater_equal<>()) == t.end();
}

TEST(DeviceClock, LeavesASoundClockAsItIs) {
  const std::vector<double> t = ticking(1000, 0.002, 77.0);
  const ClockedRows rows = read_device_clock(t, {}, {});
  EXPECT_EQ(rows.t_s, t);
  EXPECT_TRUE(rows.restarts.empty());
  EXPECT_EQ(rows.lost + rows.doubled + rows.out_of_order + rows.astray + rows.misplaced, 0u);
}

TEST(DeviceClock, UndoesTheWrapsOfA32BitMicrosecondCounter) {
  const double wrap = 4294.967296;
  std::vector<double> t = ticking(2000, 5.0, 4000.0), wrapped = t;  // 10,000 s: two wraps
  for (double& value : wrapped) value = std::fmod(value, wrap);
  const ClockedRows rows = read_device_clock(wrapped, {}, {});
  ASSERT_EQ(rows.t_s.size(), t.size());
  for (std::size_t i = 0; i < t.size(); ++i) ASSERT_NEAR(rows.t_s[i], t[i], 1e-9);
  EXPECT_TRUE(rows.restarts.empty());
  EXPECT_EQ(rows.out_of_order, 0u);
}

TEST(DeviceClock, UndoesTheWrapOfASignedCounterToo) {
  std::vector<double> t = ticking(1000, 0.02, 2140.0), wrapped = t;
  for (double& value : wrapped)
    if (value >= 2147.483648) value -= 4294.967296;
  const ClockedRows rows = read_device_clock(wrapped, {}, {});
  ASSERT_TRUE(rises(rows.t_s));
  EXPECT_NEAR(rows.t_s.back(), t.back(), 1e-9);
}

TEST(DeviceClock, UndoesAWrapInWhichRowsWereLost) {
  std::vector<double> t = ticking(1000, 0.02, 4290.0);
  t.erase(t.begin() + 240, t.begin() + 260);
  std::vector<double> wrapped = t;
  for (double& value : wrapped) value = std::fmod(value, 4294.967296);
  const ClockedRows rows = read_device_clock(wrapped, {}, {});
  EXPECT_NEAR(rows.t_s.back(), t.back(), 1e-9);
  EXPECT_EQ(rows.lost, 20u);
}

TEST(DeviceClock, MarksARestart) {
  std::vector<double> t = ticking(300, 0.02, 136.0);
  const std::vector<double> anew = ticking(500, 0.02, 0.32);
  t.insert(t.end(), anew.begin(), anew.end());
  const ClockedRows rows = read_device_clock(t, {}, {});
  EXPECT_EQ(rows.restarts, std::vector<std::size_t>{300});
  EXPECT_EQ(rows.t_s, t);
  EXPECT_EQ(rows.out_of_order, 0u);
  EXPECT_EQ(rows.lost, 0u);
}

TEST(DeviceClock, CallsItNoRestartWhenTheHostSteppedBackAsWell) {
  std::vector<double> t = ticking(500, 0.02);
  std::rotate(t.begin(), t.begin() + 250, t.end());
  const std::vector<double> host = t;
  const ClockedRows rows = read_device_clock(t, host, {});
  EXPECT_TRUE(rows.restarts.empty());
  EXPECT_EQ(rows.misplaced, 250u);
  EXPECT_EQ(rows.first_not_rising, 250u);
}

TEST(DeviceClock, PutsTwoSwappedRowsInOrderAndCountsOne) {
  std::vector<double> t = ticking(500, 0.02);
  std::swap(t[100], t[101]);
  const ClockedRows rows = read_device_clock(t, {}, {});
  EXPECT_EQ(rows.out_of_order, 1u);
  EXPECT_EQ(rows.misplaced, 1u);
  EXPECT_EQ(rows.t_s, ticking(500, 0.02));
  EXPECT_EQ(rows.order[100], 101u);
  EXPECT_EQ(rows.order[101], 100u);
}

TEST(DeviceClock, PutsDistantSwappedRowsInOrder) {
  std::vector<double> t = ticking(5000, 0.02);
  std::swap(t[100], t[2000]);
  const ClockedRows rows = read_device_clock(t, {}, {});
  EXPECT_EQ(rows.out_of_order, 2u);
  EXPECT_EQ(rows.misplaced, 2u);
  EXPECT_TRUE(rows.restarts.empty());
  EXPECT_EQ(rows.t_s, ticking(5000, 0.02));
}

TEST(DeviceClock, KeepsADoubledRowOnce) {
  std::vector<double> t = ticking(500, 0.02);
  t.insert(t.begin() + 200, t[199]);
  const ClockedRows rows = read_device_clock(t, {}, {});
  EXPECT_EQ(rows.doubled, 1u);
  EXPECT_EQ(rows.t_s.size(), 500u);
  EXPECT_EQ(rows.out_of_order, 0u);
}

TEST(DeviceClock, CountsLostRowsInGapsOfABeat) {
  std::vector<double> t = ticking(500, 0.02);
  t.erase(t.begin() + 300, t.begin() + 303);
  t.erase(t.begin() + 100);
  EXPECT_EQ(read_device_clock(t, {}, {}).lost, 4u);
}

TEST(DeviceClock, CountsNothingLostWhereADeviceKeepsNoBeat) {
  std::vector<double> t{0.0};
  for (int i = 0; i < 900; ++i)
    t.push_back(t.back() + (i % 3 == 0 ? 0.0012 : 0.0024 + 1e-5 * (i % 7)));
  t.push_back(t.back() + 0.25);
  EXPECT_EQ(read_device_clock(t, {}, {}).lost, 0u);
}

TEST(DeviceClock, BelievesSeqRatherThanGaps) {
  std::vector<double> t = ticking(400, 0.02), seq = ticking(400, 1.0, 100.0);
  for (double& value : seq) value = std::fmod(value, 256.0);  // one byte in the frame
  t.erase(t.begin() + 150, t.begin() + 160);
  seq.erase(seq.begin() + 150, seq.begin() + 160);
  EXPECT_EQ(read_device_clock(t, {}, seq).lost, 10u);
}

TEST(DeviceClock, CountsATimeFarFromAllOthersAsAstray) {
  std::vector<double> t = ticking(500, 0.02);
  t[250] = 1e9;
  const ClockedRows rows = read_device_clock(t, {}, {});
  EXPECT_EQ(rows.astray, 1u);
  EXPECT_EQ(rows.t_s.size(), 499u);
  EXPECT_NEAR(rows.t_s.back(), 499 * 0.02, 1e-12);
}

TEST(DeviceClock, FindsNearlyEveryRowOfAReversedClockMisplaced) {
  std::vector<double> t = ticking(500, 0.02);
  std::reverse(t.begin(), t.end());
  const ClockedRows rows = read_device_clock(t, {}, {});
  EXPECT_EQ(rows.misplaced, 499u);
  EXPECT_EQ(rows.first_not_rising, 1u);
}

}  // namespace
}  // namespace searig::acquisition
