#include "app/desktop/wording.h"

#include <gtest/gtest.h>

#include <limits>

namespace searig::app::desktop {
namespace {

History with_stiffness(double k, double sd) {
  History history;
  history.stiffness_nm_per_rad = {k};
  history.stiffness_sd_nm_per_rad = {sd};
  return history;
}

TEST(Wording, GivesTheStiffnessAndItsSpreadInDigitsThatCount) {
  const History history = with_stiffness(41.2345, 0.5);
  EXPECT_EQ(stiffness_words(history).toStdString(), "41.2 N·m/rad");
  EXPECT_EQ(spread_words(history).toStdString(), "±1.0 by the filter's own account");
}

TEST(Wording, SaysSoWhereTheFilterHasNotStarted) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(spread_words(with_stiffness(41.2, infinity)).toStdString(),
            "the filter has not started");
  EXPECT_TRUE(spread_words(History{}).isEmpty());
  EXPECT_EQ(stiffness_words(History{}).toStdString(), "–");
}

TEST(Wording, SaysWhatIsKnownOfTheClocks) {
  acquisition::Recording recording;
  recording.one_clock = true;
  EXPECT_EQ(clock_words(recording, {}).toStdString(), "one clock");
  recording.one_clock = false;
  EXPECT_EQ(clock_words(recording, {}).toStdString(), "–");
  acquisition::ClockMap clock;
  clock.ci95_s = 0.0042;
  clock.why = "because";
  EXPECT_EQ(clock_words(recording, clock).toStdString(), "trusted, ±4.2 ms");
  clock.trusted = false;
  EXPECT_EQ(clock_words(recording, clock).toStdString(), "not trusted, ±4.2 ms");
}

}  // namespace
}  // namespace searig::app::desktop
