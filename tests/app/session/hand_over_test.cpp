// Pieces from one thread to another.
#include "app/session/hand_over.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

namespace searig::app {
namespace {

TEST(HandOver, GivesAllInOrderAndThenNothing) {
  HandOver<int> pieces;
  const std::jthread giver([&] {
    for (int i = 0; i < 1000; ++i) pieces.give(i);
    pieces.end();
  });
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(pieces.take(), i);
  EXPECT_EQ(pieces.take(), std::nullopt);
}

TEST(HandOver, HandsOnWhatTheGiverEndedWithAfterWhatItGave) {
  HandOver<int> pieces;
  pieces.give(7);
  pieces.end(std::make_exception_ptr(std::runtime_error("the disk is gone")));
  EXPECT_EQ(pieces.take(), 7);
  EXPECT_THROW(pieces.take(), std::runtime_error);
}

TEST(HandOver, LetsTheGiverGoWhereNobodyTakes) {
  HandOver<int> pieces;
  const std::jthread giver([&] {
    while (pieces.give(1)) {
    }
  });
  EXPECT_EQ(pieces.take(), 1);
  pieces.refuse();  // or the giver would never be joined
}

TEST(MakeAhead, TakesAllInOrderAndEndsByWhatEitherThrows) {
  int taken = 0;
  make_ahead<int>(
      [](const auto& give) {
        for (int i = 0; i < 1000; ++i) give(i);
      },
      [&](int piece) { ASSERT_EQ(piece, taken++); });
  EXPECT_EQ(taken, 1000);
  EXPECT_THROW(make_ahead<int>([](const auto&) { throw std::runtime_error("torn"); }, [](int) {}),
               std::runtime_error);
  const auto for_ever = [](const auto& give) {
    while (true) give(1);
  };
  EXPECT_THROW(make_ahead<int>(for_ever, [](int) { throw std::runtime_error("enough"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace searig::app
