#include <cstdio>

#include "tests/system/running_record.h"

namespace searig {
namespace {

TEST(Durability, KilledAtFiftyInstantsLosesAtMostAQuarterOfASecond) {
  const double worst_s = worst_loss_of_kills(50, 3.0);
  std::printf("50 kills: at most %.0f ms lost\n", 1e3 * worst_s);
  EXPECT_LE(worst_s, 0.25);
}

}  // namespace
}  // namespace searig
