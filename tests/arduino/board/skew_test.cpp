// The board's clock, found from the arrivals of its frames; the board under faults. Simulated time.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "acquisition/clock/host_clock.h"
#include "acquisition/clock/ping_clock.h"
#include "acquisition/wire/line_faults.h"
#include "tests/arduino/board/board_run.h"

namespace searig::board {
namespace {

using acquisition::LoadcellSample;
using acquisition::Pong;

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

/// Pings through the real firmware: the board's clock is known to the host within a millisecond.
TEST(BoardClock, IsPlacedWithinAMillisecondByPings) {
  BoardRun run(hx711_board(-2000.0), [](double) { return 0.0; });
  std::mt19937_64 random(8);
  std::exponential_distribution<double> late(1.0 / 0.0005);
  const std::size_t frame = acquisition::ping_frame(0, 0.0).size();
  acquisition::PingClock clock({.least_there_s = acquisition::least_wire_s(frame, 115200),
                                .least_back_s = acquisition::least_wire_s(frame, 115200)});
  for (int second = 1; second <= 20; ++second) {
    run.run_until(second + 0.001 * (second * 7 % 20));  // at any phase of the frames
    const double asked_s = run.board.true_s();
    run.messages.clear();
    run.run_until(asked_s + late(random));
    run.board.receive(acquisition::ping_frame(1, asked_s));
    run.run_until(run.board.true_s() + 0.02);
    ASSERT_EQ(run.all<Pong>().size(), 1u);
    const Pong pong = run.all<Pong>().front();
    clock.take({asked_s, pong.device_received_s, pong.at.device_s, pong.at.host_s + late(random)});
  }
  // The firmware's clock begins a moment after the reset, which Firmware.Stamps... measures.
  const double device_s = 20.0, true_s = (device_s + 145e-6) / (1.0 - 2000e-6);
  const auto estimate = clock.at(device_s);
  ASSERT_TRUE(estimate);
  const double error_s = estimate->theta_s - (true_s - device_s);
  EXPECT_LT(std::abs(error_s), 1e-3);
  EXPECT_LE(std::abs(error_s), estimate->ci95_s);
  EXPECT_LT(estimate->ci95_s, 1e-3);
  EXPECT_NEAR(estimate->rate, 1.0 / (1.0 - 2000e-6), 100e-6);
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
