#include "acquisition/wire/decoder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/acquisition/wire/sender.h"

namespace searig::acquisition {
namespace {

constexpr std::uint32_t kStep = 20000;  // us

std::vector<Bytes> loadcell_frames(Sender& sender, int count, std::uint32_t from_us = 0) {
  std::vector<Bytes> frames;
  for (int i = 0; i < count; ++i) {
    frames.push_back(sender.loadcell(from_us + static_cast<std::uint32_t>(i) * kStep, 1000 + i));
  }
  return frames;
}

TEST(Decoder, GivesSamplesInSiUnits) {
  Sender sender;
  Decoder decoder;
  const auto messages =
      decode_all(decoder, {sender.module(5'000'000, 1'500'000), sender.module(5'020'000, -7)});
  const auto samples = only<ModuleSample>(messages);
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].input_angle_rad, 1.5);
  EXPECT_EQ(samples[0].at.device_s, 5.0);
  EXPECT_EQ(samples[1].at.sequence, 1u);
  EXPECT_DOUBLE_EQ(samples[1].at.host_s, 100.04);
  EXPECT_TRUE(std::isnan(samples[0].commanded_angle_rad));
  EXPECT_TRUE(std::isnan(samples[0].spring_temperature_c));
}

TEST(Decoder, IsIndifferentToWhereReadsWereCut) {
  Sender sender;
  Bytes all;
  for (const Bytes& frame : loadcell_frames(sender, 200)) {
    all.insert(all.end(), frame.begin(), frame.end());
  }
  std::mt19937 random(3);
  for (int run = 0; run < 20; ++run) {
    Decoder decoder;
    std::vector<Message> messages;
    for (std::size_t at = 0; at < all.size();) {
      const std::size_t count = std::min<std::size_t>(1 + random() % 60, all.size() - at);
      decoder.push({all.data() + at, count}, 100.0 + static_cast<double>(at) * 1e-3, messages);
      at += count;
    }
    EXPECT_EQ(only<LoadcellSample>(messages).size(), 200u);
    EXPECT_EQ(decoder.counters().lost, 0u);
  }
}

TEST(Decoder, CountsLostDoubledAndLateFrames) {
  Sender sender;
  const auto frames = loadcell_frames(sender, 10);
  Decoder decoder(Framing::datagrams);
  const auto messages = decode_all(decoder, {frames[0], frames[1], frames[1], frames[4], frames[3],
                                             frames[3], frames[5], frames[9], frames[0]});
  EXPECT_EQ(only<LoadcellSample>(messages).size(), 6u);
  const WireCounters& counters = decoder.counters();
  EXPECT_EQ(counters.doubled, 3u);
  EXPECT_EQ(counters.out_of_order, 1u);
  EXPECT_EQ(counters.lost, 4u);  // 2, 6, 7, 8
  EXPECT_EQ(counters.lost_samples, 4u);
  EXPECT_EQ(counters.received, 6u);
}

TEST(Decoder, FollowsTheClockThroughItsWrapAndThroughALongSilence) {
  Sender sender;
  Decoder decoder;
  std::vector<Message> messages;
  const auto at = [&](double device_s) {
    const auto us = static_cast<std::uint32_t>(std::llround(device_s * 1e6) & 0xFFFFFFFFll);
    decoder.push(sender.loadcell(us, 0), 50.0 + device_s, messages);
  };
  // Around the wrap at 4294.97 s; then after 2.5 wraps of silence.
  for (int i = 0; i < 100; ++i) at(4294.0 + 0.02 * i);
  for (int i = 0; i < 100; ++i) at(15000.0 + 0.02 * i);
  const auto samples = only<LoadcellSample>(messages);
  ASSERT_EQ(samples.size(), 200u);
  for (std::size_t i = 0; i < 200; ++i) {
    const double expected = i < 100 ? 4294.0 + 0.02 * static_cast<double>(i)
                                    : 15000.0 + 0.02 * static_cast<double>(i - 100);
    EXPECT_NEAR(samples[i].at.device_s, expected, 1e-9);
  }
  EXPECT_EQ(decoder.counters().restarts, 0u);
}

TEST(Decoder, TellsARestartAndCountsItsFirstFramesIfTheyAreLost) {
  Sender sender;
  auto frames = loadcell_frames(sender, 10, 90'000'000);
  const auto old = frames[9];
  sender.restart();
  const auto after = loadcell_frames(sender, 10);
  frames.insert(frames.end(), after.begin() + 3, after.end());
  frames.push_back(old);  // replayed from before the restart
  Decoder decoder(Framing::datagrams);
  const auto messages = decode_all(decoder, frames);
  const auto samples = only<LoadcellSample>(messages);
  const auto restarts = only<Restart>(messages);
  ASSERT_EQ(restarts.size(), 1u);
  EXPECT_EQ(restarts[0].run, 1u);
  EXPECT_EQ(restarts[0].boot, 8);
  ASSERT_EQ(samples.size(), 17u);
  EXPECT_EQ(samples[10].at.run, 1u);
  EXPECT_EQ(samples[10].at.sequence, 3u);
  EXPECT_EQ(decoder.counters().lost, 3u);
  EXPECT_EQ(decoder.counters().restarts, 1u);
  EXPECT_EQ(decoder.counters().doubled, 1u);
}

TEST(Decoder, GoesOnBehindAGapAndMarksWhatItCost) {
  Sender sender;
  const auto frames = loadcell_frames(sender, 200);
  Decoder decoder;
  std::vector<Message> messages;
  for (int i = 0; i < 50; ++i) decoder.push(frames[i], 10.0 + 0.02 * i, messages);
  decoder.push({frames[50].data(), 9}, 11.0, messages);
  decoder.gap();
  decoder.push({frames[150].data() + 5, frames[150].size() - 5}, 13.0, messages);
  for (int i = 151; i < 200; ++i) decoder.push(frames[i], 10.0 + 0.02 * i, messages);
  EXPECT_EQ(only<LoadcellSample>(messages).size(), 99u);
  EXPECT_EQ(decoder.counters().lost, 101u);
  EXPECT_EQ(decoder.counters().lost_in_gaps, 101u);
  EXPECT_EQ(decoder.counters().parser.cut, 2u);
  EXPECT_EQ(decoder.counters().parser.malformed + decoder.counters().parser.bad_crc, 0u);
  EXPECT_EQ(decoder.counters().restarts, 0u);
}

/// A suspended module: nothing for minutes, then its next frame, by its own clock a moment later.
TEST(Decoder, TellsAPauseFromARestart) {
  for (const double silence_s : {70.0, 1000.0, 3000.0}) {
    Sender sender;
    const auto frames = loadcell_frames(sender, 100, 5'000'000);
    Decoder decoder(Framing::datagrams);
    std::vector<Message> messages;
    for (int i = 0; i < 50; ++i) decoder.push(frames[i], 10.0 + 0.02 * i, messages);
    decoder.gap();
    for (int i = 50; i < 100; ++i) decoder.push(frames[i], 10.0 + silence_s + 0.02 * i, messages);
    const auto samples = only<LoadcellSample>(messages);
    ASSERT_EQ(samples.size(), 100u) << silence_s;
    EXPECT_EQ(samples[99].at.run, 1u);
    EXPECT_NEAR(samples[99].at.device_s - samples[50].at.device_s, 0.98, 1e-9);
    ASSERT_EQ(only<Restart>(messages).size(), 1u);
    EXPECT_TRUE(only<Restart>(messages)[0].paused);
    EXPECT_EQ(decoder.counters().pauses, 1u);
    EXPECT_EQ(decoder.counters().restarts + decoder.counters().lost, 0u);
  }
}

/// The second frame must go on too: of another type, it may be far behind.
TEST(Decoder, TakesNoPauseForWhatOnlyOneTypeSays) {
  Sender sender;
  Decoder decoder;
  std::vector<Message> messages;
  for (int i = 0; i < 300; ++i) {
    decoder.push(sender.loadcell(5'000'000 + i * kStep, i), 10.0 + 0.02 * i, messages);
    decoder.push(sender.module(5'000'000 + i * kStep, i), 10.0 + 0.02 * i, messages);
  }
  decoder.gap();
  const std::uint32_t later_us = 5'000'000 + 300 * kStep;
  decoder.push(sender.loadcell(later_us, 1), 500.0, messages);
  sender.sequences[wire::Type::module_sample] = 3;
  decoder.push(sender.module(later_us + kStep, 1), 500.02, messages);
  EXPECT_EQ(decoder.counters().pauses, 0u);
  EXPECT_EQ(decoder.counters().restarts, 1u);
}

TEST(Decoder, TakesAnotherDeviceBehindAGapForARestartEvenWithTheSameBoot) {
  Sender one, other;
  const auto first = loadcell_frames(one, 50, 80'000'000);
  const auto second = loadcell_frames(other, 50);
  Decoder decoder;
  auto messages = decode_all(decoder, first);
  decoder.gap();
  std::vector<Message> more;
  double host_s = 110.0;
  for (const Bytes& bytes : second) decoder.push(bytes, host_s += 0.02, more);
  EXPECT_EQ(only<LoadcellSample>(more).size(), 50u);
  EXPECT_EQ(decoder.counters().restarts, 1u);
}

TEST(Decoder, IsNotLedAstrayByAGoodFrameThatCannotBe) {
  // A damaged frame that passes its CRC by chance: the boot, the sequence or the time is wrong.
  for (int fault = 0; fault < 3; ++fault) {
    Sender sender;
    auto frames = loadcell_frames(sender, 20);
    Sender wrong;
    wrong.boot = fault == 0 ? 99 : wrong.boot;
    wrong.sequences[wire::Type::loadcell_sample] = fault == 1 ? 3'000'000'000u : 20u;
    frames.push_back(wrong.loadcell(fault == 2 ? 3'000'000'000u : 20 * kStep, -1));
    const auto rest = loadcell_frames(sender, 20, 20 * kStep);
    frames.insert(frames.end(), rest.begin(), rest.end());
    Decoder decoder;
    const auto samples = only<LoadcellSample>(decode_all(decoder, frames));
    EXPECT_EQ(samples.size(), 40u) << fault;
    for (const auto& sample : samples) EXPECT_NE(sample.counts, -1);
    EXPECT_EQ(decoder.counters().implausible, 1u);
    EXPECT_EQ(decoder.counters().lost, 0u);
    EXPECT_EQ(decoder.counters().restarts, 0u);
  }
}

TEST(Decoder, IsNotLedAstrayByTwoThatDoNotGoTogether) {
  Sender sender, wrong, other;
  auto frames = loadcell_frames(sender, 20);
  wrong.boot = 99;
  other.boot = 98;
  frames.push_back(wrong.loadcell(0, -1));
  frames.push_back(other.loadcell(0, -1));
  frames.push_back(wrong.loadcell(3'000'000'000u, -1));
  const auto rest = loadcell_frames(sender, 20, 20 * kStep);
  frames.insert(frames.end(), rest.begin(), rest.end());
  Decoder decoder;
  EXPECT_EQ(only<LoadcellSample>(decode_all(decoder, frames)).size(), 40u);
  EXPECT_EQ(decoder.counters().implausible, 3u);
  EXPECT_EQ(decoder.counters().restarts, 0u);
}

TEST(Decoder, NamesWhatIsWrongWithFrames) {
  Sender sender;
  auto frames = loadcell_frames(sender, 3);
  Bytes bad_crc = frames[2];
  bad_crc[5] ^= 0x10;
  frames.push_back(bad_crc);
  frames.push_back({1, 2, 3, 0});   // no frame is so short
  frames.push_back(Bytes(300, 9));  // the longest frame is shorter
  frames.push_back({0, 0, 0});      // idle
  frames.push_back(sender.frame(wire::Type::loadcell_sample, wire::LoadcellPayload{}, 0, 2));
  frames.push_back(sender.frame(wire::Type::ping, wire::PingPayload{}, 0));  // an echo of the host
  frames.push_back(sender.frame(wire::Type::pong, wire::LoadcellPayload{}, 0));
  Decoder decoder;
  decode_all(decoder, frames);
  const ParserCounters& parser = decoder.counters().parser;
  EXPECT_EQ(parser.frames, 3u);
  EXPECT_EQ(parser.bad_crc, 1u);
  EXPECT_EQ(parser.too_long, 1u);
  EXPECT_EQ(parser.malformed, 2u);
  EXPECT_EQ(parser.other_version, 1u);
  EXPECT_EQ(parser.unknown_type, 1u);
}

TEST(Decoder, DoesNotJoinDatagrams) {
  Sender sender;
  const auto frames = loadcell_frames(sender, 4);
  const Bytes head(frames[2].begin(), frames[2].begin() + 10);
  const Bytes tail(frames[2].begin() + 10, frames[2].end());
  Decoder decoder(Framing::datagrams);
  const auto messages = decode_all(decoder, {frames[0], frames[1], head, tail, frames[3]});
  EXPECT_EQ(only<LoadcellSample>(messages).size(), 3u);
  EXPECT_EQ(decoder.counters().parser.malformed + decoder.counters().parser.bad_crc, 2u);
  EXPECT_EQ(decoder.counters().lost, 1u);
}

TEST(Decoder, AddsUpTheDevicesOwnOverruns) {
  Sender sender;
  Decoder decoder;
  decode_all(decoder, {sender.loadcell(0, 0, 65530), sender.loadcell(kStep, 0, 65535),
                       sender.loadcell(2 * kStep, 0, 4)});
  EXPECT_EQ(decoder.counters().device_overruns, 10u);
}

}  // namespace
}  // namespace searig::acquisition
