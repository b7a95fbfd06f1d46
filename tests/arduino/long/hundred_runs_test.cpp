#include <gtest/gtest.h>

#include "tests/arduino/board/recorded_run.h"

namespace searig::board {
namespace {

TEST(PingedBoard, AHundredRecordingsOfTheFirmware) {
  expect_within_a_millisecond(100, 30.0);
}

}  // namespace
}  // namespace searig::board
