// What the sketch does, seen from the wire.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/arduino/board/board_run.h"

namespace searig::board {
namespace {

using acquisition::Identity;
using acquisition::LoadcellSample;
using acquisition::Pong;

BoardSettings settings_for(const std::string& sensor) {
  BoardSettings settings;
  settings.firmware = firmware(sensor);
  return settings;
}

/// A saw tooth of the force says when it was measured: rises from -80 to 80 N in 80 ms, and again.
constexpr double kTooth = 0.08;
double saw_tooth(double true_s) {
  return 2000.0 * std::fmod(true_s, kTooth) - 80.0;
}

/// Device time minus true time of each reading, s, by the force that it shows. Readings near an end
/// of the tooth may belong to two.
std::vector<double> stamp_errors(const BoardRun& run, double newton_per_count, double rest) {
  std::vector<double> errors;
  for (const auto& sample : run.all<LoadcellSample>()) {
    if (sample.settling || sample.repeated) continue;
    const double in_tooth_s = ((sample.counts - rest) * newton_per_count + 80.0) / 2000.0;
    if (in_tooth_s < 0.005 || in_tooth_s > kTooth - 0.005) continue;
    errors.push_back(std::remainder(sample.at.device_s - in_tooth_s, kTooth));
  }
  return errors;
}

/// The device's clock begins at its reset, but for the first instructions; apart from that a stamp
/// is right within the jitter of interrupts and the steps of micros().
void expect_right_stamps(std::vector<double> errors) {
  ASSERT_GT(errors.size(), 700u);
  std::nth_element(errors.begin(), errors.begin() + 350, errors.end());
  const double middle = errors[350];
  EXPECT_NEAR(middle, 0.0, 250e-6);
  for (const double error : errors) EXPECT_NEAR(error, middle, 60e-6);
}

TEST(Firmware, SendsFiftyFramesASecondWithoutALoss) {
  for (const char* sensor : {"hx711", "analogue"}) {
    BoardRun run(settings_for(sensor), [](double) { return 3.0; });
    run.run_until(20.0);
    const auto samples = run.all<LoadcellSample>();
    const auto& counters = run.decoder.counters();
    EXPECT_NEAR(static_cast<double>(samples.size()), 1000.0, 2.0) << sensor;
    EXPECT_EQ(counters.lost, 0u);
    EXPECT_EQ(counters.parser.bad_crc + counters.parser.malformed, 0u);
    EXPECT_EQ(counters.device_overruns, 0u);
    EXPECT_EQ(counters.implausible, 0u);
    EXPECT_EQ(run.board.hx711().powered_down(), 0u);
  }
}

/// Also while the sketch is busy answering, and reads it later.
TEST(Firmware, StampsAnHx711ReadingWhenItIsReady) {
  const auto settings = settings_for("hx711");
  BoardRun run(settings, saw_tooth);
  for (std::uint32_t ping = 1; ping <= 1800; ++ping) {
    run.run_until(0.0111 * ping);
    run.board.receive(acquisition::ping_frame(ping, run.board.true_s()));
  }
  expect_right_stamps(stamp_errors(run, 1.0 / settings.counts_per_newton, settings.counts_at_rest));
  EXPECT_GT(run.all<Pong>().size(), 1000u);
}

TEST(Firmware, StampsAnAnalogueReadingAtTheMiddleOfItsBurst) {
  const auto settings = settings_for("analogue");
  BoardRun run(settings, saw_tooth);
  run.run_until(20.0);
  const double gain = 5000.0 / (16 * 1023 * settings.mv_per_newton);
  expect_right_stamps(stamp_errors(run, gain, 16 * 511));  // the converter rounds down
}

TEST(Firmware, AnswersAPingWithTwoTimesOfItsOwnClock) {
  auto settings = settings_for("hx711");
  settings.skew_ppm = 200.0;
  BoardRun run(settings, [](double) { return 0.0; });
  run.run_until(0.5);
  for (std::uint32_t id = 0; id < 50; ++id) {
    const double sent_s = run.board.true_s();
    run.board.receive(acquisition::ping_frame(id, sent_s));
    run.run_until(sent_s + 0.0337);
  }
  const auto pongs = run.all<Pong>();
  ASSERT_EQ(pongs.size(), 50u);
  double least = 1.0;
  for (const Pong& pong : pongs) {
    const double rate = 1.0 + settings.skew_ppm * 1e-6;
    const double there = pong.device_received_s / rate - pong.host_sent_s;
    const double back = pong.at.host_s - pong.at.device_s / rate;
    EXPECT_GE(pong.at.device_s, pong.device_received_s);
    EXPECT_NEAR(0.5 * (there - back), 0.0, 0.7e-3);
    least = std::min(least, there + back);
  }
  RecordProperty("least_round_trip_ms", std::to_string(1e3 * least));
  EXPECT_LT(least, 7e-3);
}

TEST(Firmware, KeepsTareGainAndNameOverAReset) {
  BoardRun run(settings_for("hx711"), [](double) { return 0.0; });
  run.run_until(0.5);
  run.board.receive(acquisition::calibration_frame(84123, 0.0005f));
  run.run_until(1.0);
  run.board.receive(acquisition::name_frame("bench seven"));
  run.run_until(1.5);
  run.board.reset();
  run.run_until(2.0);
  const auto identities = run.all<Identity>();
  ASSERT_EQ(identities.size(), 4u);  // at each start and after each setting
  EXPECT_EQ(identities[0].name, "loadcell");
  EXPECT_EQ(identities[0].newton_per_count, 0.0);
  EXPECT_EQ(identities[3].at.run, 1u);
  EXPECT_EQ(identities[3].name, "bench seven");
  EXPECT_EQ(identities[3].tare_counts, 84123);
  EXPECT_FLOAT_EQ(static_cast<float>(identities[3].newton_per_count), 0.0005f);
  EXPECT_EQ(identities[3].rate_hz, 50.0);
  EXPECT_EQ(identities[3].kind, Identity::Kind::loadcell_hx711);
  EXPECT_EQ(run.decoder.counters().restarts, 1u);
}

TEST(Firmware, CountsItsStartsInTheEeprom) {
  auto settings = settings_for("hx711");
  settings.last_boot = 41;
  BoardRun run(settings, [](double) { return 0.0; });
  for (int start = 1; start <= 3; ++start) {
    run.run_until(0.3 * start);
    run.board.reset();
  }
  run.run_until(1.2);
  const auto restarts = run.all<acquisition::Restart>();
  ASSERT_EQ(restarts.size(), 3u);
  EXPECT_EQ(restarts[0].boot, 43);
  EXPECT_EQ(restarts[2].boot, 45);
}

TEST(Firmware, SaysWhenTheConverterIsSlowOrAtItsLimit) {
  auto settings = settings_for("hx711");
  settings.hx711_hz = 11.7;
  BoardRun slow(settings, [](double) { return 0.0; });
  slow.run_until(10.0);
  const auto& counters = slow.decoder.counters();
  const double fresh = static_cast<double>(counters.samples - counters.repeated);
  EXPECT_NEAR(fresh / 10.0, 11.7, 0.3);
  for (const char* sensor : {"hx711", "analogue"}) {
    BoardRun high(settings_for(sensor), [](double t) { return t < 1.0 ? 0.0 : 1e5; });
    high.run_until(2.0);
    EXPECT_NEAR(static_cast<double>(high.decoder.counters().at_limit), 50.0, 2.0) << sensor;
  }
}

}  // namespace
}  // namespace searig::board
