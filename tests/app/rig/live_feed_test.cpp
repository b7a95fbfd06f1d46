#include "app/rig/live_feed.h"

#include <gtest/gtest.h>

#include "acquisition/source/source.h"

namespace searig::app {
namespace {

TEST(LiveNews, AnEventIsAsLongAgoAsItCameBeforeTheNewestSample) {
  LiveNews news;
  news.now_s = 20.0, news.newest_host_s = 5000.0;
  acquisition::Event event;
  event.host_s = 4998.5;
  EXPECT_DOUBLE_EQ(news.time_of(event), 18.5);
}

/// The host's own clock runs since it was switched on; no axis shows that.
TEST(LiveNews, AnEventBeforeTheFirstSampleIsNow) {
  acquisition::Event event;
  event.host_s = acquisition::host_now_s() - 0.2;
  const double time_s = LiveNews{}.time_of(event);
  EXPECT_LE(time_s, -0.2 + 1e-6);
  EXPECT_GT(time_s, -60.0);
}

}  // namespace
}  // namespace searig::app
