#include <gtest/gtest.h>

#include "tests/arduino/board/recorded_run.h"

namespace searig::board {
namespace {

TEST(PingedBoard, ARecordingOfTheFirmwareIsPlacedWithinAMillisecond) {
  expect_within_a_millisecond(3, 20.0);
}

}  // namespace
}  // namespace searig::board
