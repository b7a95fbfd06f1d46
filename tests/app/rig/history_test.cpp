#include "app/rig/history.h"

#include <gtest/gtest.h>

namespace searig::app {
namespace {

TEST(History, ErrorIsThePapers) {
  History history;
  history.t_s = {0, 1, 2, 3};
  history.estimated_nm = {1, 1, 1, 1};
  history.measured_t_s = {0.5, 1.5, 2.5, 9.0};  // the last has no estimate beside it
  history.measured_nm = {2, -2, 1, 100};
  EXPECT_DOUBLE_EQ(*error_percent(history), 100.0 * (1 + 3 + 0) / 5);
  EXPECT_DOUBLE_EQ(*error_percent(history, 1.0), 100.0 * 3 / 3);
  EXPECT_FALSE(error_percent(History{}).has_value());
}

}  // namespace
}  // namespace searig::app
