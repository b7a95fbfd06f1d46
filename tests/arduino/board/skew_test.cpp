// The board's clock, found from the arrivals of its frames; the board under faults. Simulated time.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "acquisition/clock/host_clock.h"
#include "acquisition/wire/line_faults.h"
#include "tests/arduino/board/board_run.h"

namespace searig::board {
namespace {

using acquisition::LoadcellSample;

BoardSettings hx711_board(double skew_ppm = 0.0) {
  BoardSettings settings;
  settings.firmware = firmware("hx711");
  settings.skew_ppm = skew_ppm;
  return settings;
}

TEST(BoardClock, IsFoundWithinTwoPpmInAMinute) {
  for (const double skew_ppm : {200.0, -2000.0}) {
    BoardRun run(hx711_board(skew_ppm), [](double) { return 0.0; });
    run.run_until(60.0);
    std::mt19937_64 random(5);
    std::exponential_distribution<double> late(1.0 / 0.001);
    std::vector<double> sent_s, host_s;
    for (const auto& sample : run.all<LoadcellSample>()) {
      if (sample.repeated) continue;
      sent_s.push_back(sample.sent_s);
      host_s.push_back(
          std::max(sample.at.host_s + late(random), host_s.empty() ? 0.0 : host_s.back()));
    }
    const double found_ppm = (1.0 / acquisition::fit_host_line(sent_s, host_s).rate() - 1.0) * 1e6;
    EXPECT_NEAR(found_ppm, skew_ppm, 2.0);
    EXPECT_EQ(run.decoder.counters().lost, 0u);
    EXPECT_EQ(run.decoder.counters().parser.bad_crc, 0u);
  }
}

TEST(BoardOnABadLine, HandsOnNoSampleThatItDidNotSend) {
  SimulatedBoard board(hx711_board(), [](double true_s) { return 10.0 * true_s; });
  acquisition::Decoder clean, faulty;
  acquisition::LineFaults line(11);
  line.shares = {.drop = 0.01, .duplicate = 0.01, .flip = 0.001};
  std::vector<acquisition::Message> sent, heard;
  std::vector<std::uint8_t> frame;
  for (int second = 1; second <= 30; ++second) {
    if (second % 10 == 0) board.reset();
    board.run_until(second);
    for (const auto& [byte, true_s] : board.take_sent()) {
      frame.push_back(byte);
      if (byte != 0) continue;
      clean.push(frame, true_s, sent);
      faulty.push(line.pass(frame), true_s, heard);
      frame.clear();
    }
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, LoadcellSample> truth;
  for (const auto& message : sent) {
    const auto* sample = std::get_if<LoadcellSample>(&message);
    if (sample != nullptr) truth[{sample->at.run, sample->at.sequence}] = *sample;
  }
  std::size_t taken = 0;
  for (const auto& message : heard) {
    const auto* sample = std::get_if<LoadcellSample>(&message);
    if (sample == nullptr) continue;
    ++taken;
    const auto found = truth.find({sample->at.run, sample->at.sequence});
    ASSERT_NE(found, truth.end());
    EXPECT_EQ(sample->counts, found->second.counts);
    EXPECT_EQ(sample->at.device_s, found->second.at.device_s);
  }
  EXPECT_EQ(clean.counters().restarts, 3u);
  EXPECT_EQ(faulty.counters().restarts, 3u);
  EXPECT_GT(taken, 1000u);
  EXPECT_LT(taken, 1400u);
  // What is lost right before a reset, or before anything was heard, leaves no gap behind it.
  EXPECT_NEAR(static_cast<double>(taken + faulty.counters().lost_samples),
              static_cast<double>(truth.size()), 6.0);
}

}  // namespace
}  // namespace searig::board
