// The practice recordings against the clocks that made them. Only tests read answers.json.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "acquisition/clock/synchronise.h"

namespace searig::acquisition {
namespace {

namespace fs = std::filesystem;
const fs::path kPractice = fs::path(SEARIG_SHARED_DIR) / "practice";

/// device time = true time * rate + offset
struct TrueClock {
  double rate, offset_s;
  double at(double true_s) const { return true_s * rate + offset_s; }
};

TrueClock true_clock(const nlohmann::json& clock, const std::string& device) {
  return {1.0 + 1e-6 * clock.at(device + "_rate_error_ppm").get<double>(),
          clock.at(device + "_offset_s").get<double>()};
}

TEST(Practice, EveryLoadcellClockIsPlacedWithinItsBounds) {
  if (!fs::exists(kPractice)) GTEST_SKIP() << kPractice << " is not there";
  const nlohmann::json answers = nlohmann::json::parse(std::ifstream(kPractice / "answers.json"));
  int covered = 0, recordings = 0;
  for (const auto& [name, answer] : answers.items()) {
    SCOPED_TRACE(name);
    const Recording recording = read_recording(kPractice / "recordings" / name);
    const ClockMap map = synchronise(recording);
    EXPECT_TRUE(map.trusted) << map.why;
    const TrueClock module = true_clock(answer.at("clock"), "module");
    const TrueClock loadcell = true_clock(answer.at("clock"), "loadcell");
    EXPECT_NEAR(map.rate, module.rate / loadcell.rate, 3e-6);

    const auto error = [&](double loadcell_s) {
      const double true_s = (loadcell_s - loadcell.offset_s) / loadcell.rate;
      return std::abs(map.to_module(loadcell_s) - module.at(true_s));
    };
    const std::vector<double>& t_s = recording.loadcell.t_s;
    const double bound_s = name[0] == 'r' ? 0.0025 : 0.005;
    EXPECT_LT(std::max(error(t_s.front()), error(t_s.back())), bound_s);
    covered += error(0.5 * (t_s.front() + t_s.back())) <= map.ci95_s;
    EXPECT_LT(map.ci95_s, 0.005) << "an interval that says nothing covers everything";
    ++recordings;
  }
  EXPECT_EQ(recordings, 52);
  EXPECT_GE(covered, 0.9 * recordings);
}

TEST(Practice, SwappedClocksAreOtherClocks) {
  if (!fs::exists(kPractice)) GTEST_SKIP() << kPractice << " is not there";
  Recording recording = read_recording(kPractice / "recordings" / "r003");
  const ClockMap there = synchronise(recording);
  std::swap(recording.module, recording.loadcell);
  const ClockMap back = synchronise(recording);
  EXPECT_GT(std::abs(there.rate - back.rate), 1e-3);
  EXPECT_NEAR(there.rate * back.rate, 1.0, 1e-6);  // the way back is the inverse of the way there
  EXPECT_NEAR(back.to_module(there.to_module(500.0)), 500.0, 1e-3);
}

TEST(Practice, RowsLostOnTheLoadcellsWireAreThoseThatSeqMisses) {
  if (!fs::exists(kPractice)) GTEST_SKIP() << kPractice << " is not there";
  const Recording recording = read_recording(kPractice / "recordings" / "r002");
  EXPECT_EQ(recording.loadcell.counts.received, 3717u);
  EXPECT_EQ(recording.loadcell.counts.lost, 33u);
  EXPECT_EQ(recording.module.counts.lost, 18750u - 18573u);
  EXPECT_EQ(recording.module.counts.doubled + recording.module.counts.garbled +
                recording.module.counts.out_of_order,
            0u);
}

}  // namespace
}  // namespace searig::acquisition
