// The decoder behind a bad line: what it hands on was sent, and what was lost is counted.
#include "acquisition/wire/line_faults.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/acquisition/wire/sender.h"

namespace searig::acquisition {
namespace {

struct Trial {
  std::uint64_t sent = 0, taken = 0, wrong = 0;
  WireCounters counters;
};

/// Samples of a 1 kHz module through a line with faults.
Trial run(const FaultShares& shares, std::uint64_t seed, int count) {
  Sender sender;
  LineFaults line(seed);
  line.shares = shares;
  Decoder decoder;
  Trial trial;
  std::map<std::uint32_t, std::int32_t> truth;
  std::mt19937 random(static_cast<unsigned>(seed));
  std::vector<Message> messages;
  for (int i = 0; i < count; ++i) {
    const auto value = static_cast<std::int32_t>(random()) / 2;
    truth[static_cast<std::uint32_t>(i)] = value;
    const auto bytes = line.pass(sender.module(static_cast<std::uint32_t>(i) * 1000u, value));
    decoder.push(bytes, 50.0 + 1e-3 * i, messages);
    ++trial.sent;
    for (const auto& sample : only<ModuleSample>(messages)) {
      ++trial.taken;
      const auto found = truth.find(sample.at.sequence);
      trial.wrong += found == truth.end() || sample.input_angle_rad != found->second / 1e6;
    }
    messages.clear();
  }
  trial.counters = decoder.counters();
  return trial;
}

TEST(LineFaults, NoWrongSampleIsTakenAtAThousandthOfWrongBits) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Trial trial = run({.flip = 0.001}, seed, 60'000);
    EXPECT_EQ(trial.wrong, 0u);
    EXPECT_GT(trial.taken, 40'000u);
    EXPECT_LT(trial.taken, 50'000u);  // a frame has 344 bits: 71 % come through whole
    EXPECT_NEAR(static_cast<double>(trial.taken + trial.counters.lost),
                static_cast<double>(trial.sent), 5.0);
    EXPECT_EQ(trial.counters.restarts, 0u);
  }
}

TEST(LineFaults, LossAndDoublingAreCountedToTheFrame) {
  const Trial trial = run({.drop = 0.01, .duplicate = 0.02}, 9, 60'000);
  EXPECT_EQ(trial.wrong, 0u);
  EXPECT_EQ(trial.taken + trial.counters.lost, trial.sent);
  EXPECT_NEAR(static_cast<double>(trial.counters.lost), 600.0, 100.0);
  EXPECT_NEAR(static_cast<double>(trial.counters.doubled), 1188.0, 140.0);
  EXPECT_EQ(trial.counters.parser.bad_crc, 0u);
}

}  // namespace
}  // namespace searig::acquisition
