#include <gtest/gtest.h>

#include <random>

#include "arduino/firmware/payloads.h"

namespace searig::wire {
namespace {

TEST(Crc16, HasTheCheckValueOfItsCatalogue) {
  // CRC-16/CCITT-FALSE (also IBM-3740) of "123456789".
  const char* text = "123456789";
  EXPECT_EQ(crc16(reinterpret_cast<const std::uint8_t*>(text), 9), 0x29B1);
}

TEST(Crc16, FindsEveryOneTwoAndThreeWrongBits) {
  std::array<std::uint8_t, kHeaderSize + LoadcellPayload::kSize> frame{1, 1, 7};
  const std::uint16_t right = crc16(frame.data(), frame.size());
  const std::size_t bits = frame.size() * 8;
  const auto flip = [&](std::size_t bit) { frame[bit / 8] ^= std::uint8_t(1u << bit % 8); };
  for (std::size_t a = 0; a < bits; ++a) {
    flip(a);
    ASSERT_NE(crc16(frame.data(), frame.size()), right);
    for (std::size_t b = a + 1; b < bits; ++b) {
      flip(b);
      ASSERT_NE(crc16(frame.data(), frame.size()), right);
      for (std::size_t c = b + 1; c < bits; c += 7) {
        flip(c);
        ASSERT_NE(crc16(frame.data(), frame.size()), right);
        flip(c);
      }
      flip(b);
    }
    flip(a);
  }
}

TEST(Cobs, EncodesTheExamplesOfItsPaper) {
  const auto encoded = [](std::vector<std::uint8_t> bytes) {
    std::vector<std::uint8_t> out(bytes.size() + 1);
    out.resize(cobs_encode(bytes.data(), bytes.size(), out.data()));
    return out;
  };
  using Bytes = std::vector<std::uint8_t>;
  EXPECT_EQ(encoded({}), (Bytes{1}));
  EXPECT_EQ(encoded({0}), (Bytes{1, 1}));
  EXPECT_EQ(encoded({0, 0}), (Bytes{1, 1, 1}));
  EXPECT_EQ(encoded({0x11, 0x22, 0, 0x33}), (Bytes{3, 0x11, 0x22, 2, 0x33}));
  EXPECT_EQ(encoded({0x11, 0, 0, 0}), (Bytes{2, 0x11, 1, 1, 1}));
}

TEST(Cobs, GivesBackWhatItWasGivenAndHoldsNoZero) {
  std::mt19937 random(1);
  for (int run = 0; run < 20000; ++run) {
    std::vector<std::uint8_t> bytes(random() % (kMaxFrame + 1));
    for (auto& byte : bytes) byte = random() % 3 == 0 ? 0 : static_cast<std::uint8_t>(random());
    std::vector<std::uint8_t> encoded(bytes.size() + 1), decoded(bytes.size() + 1);
    encoded.resize(cobs_encode(bytes.data(), bytes.size(), encoded.data()));
    ASSERT_EQ(std::count(encoded.begin(), encoded.end(), 0), 0);
    decoded.resize(cobs_decode(encoded.data(), encoded.size(), decoded.data()));
    ASSERT_EQ(decoded, bytes);
  }
}

TEST(Cobs, RefusesWhatIsNoEncoding) {
  std::uint8_t out[8];
  const std::uint8_t runs_over[] = {5, 1, 2};
  const std::uint8_t holds_zero[] = {3, 0, 2};
  const std::uint8_t block_too_long[] = {0xFF, 1, 2};
  EXPECT_EQ(cobs_decode(runs_over, 3, out), 0u);
  EXPECT_EQ(cobs_decode(holds_zero, 3, out), 0u);
  EXPECT_EQ(cobs_decode(block_too_long, 3, out), 0u);
}

TEST(Payloads, FillTheSizeThatTheyState) {
  std::uint8_t bytes[kMaxPayload];
  const ModulePayload module{1, -2, 3, kAbsent32, 5, -600, kAbsent16, 7};
  module.write(bytes);
  const ModulePayload back = ModulePayload::read(bytes);
  EXPECT_EQ(back.output_angle_urad, -2);
  EXPECT_EQ(back.commanded_angle_urad, kAbsent32);
  EXPECT_EQ(back.winding_temperature_cc, -600);
  EXPECT_EQ(back.overruns, 7);
  const LoadcellPayload loadcell{-8388608, LoadcellPayload::at_limit, 65535, 10700};
  loadcell.write(bytes);
  EXPECT_EQ(LoadcellPayload::read(bytes).counts, -8388608);
  EXPECT_EQ(LoadcellPayload::read(bytes).overruns, 65535);
  EXPECT_EQ(LoadcellPayload::read(bytes).age_us, 10700);
  EXPECT_LE(IdentityPayload::kSize, kMaxPayload);
}

}  // namespace
}  // namespace searig::wire
