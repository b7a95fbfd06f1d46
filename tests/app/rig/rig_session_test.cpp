// The whole rig, with its real firmware on the simulated board, connected as the window does it.
#include "app/rig/rig_session.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "acquisition/calibration/loadcell_calibration.h"
#include "app/rig/weighing.h"
#include "app/session/session.h"
#include "tests/temporary_folder.h"

namespace searig::app {
namespace {

/// A view that looks thirty times a second.
class Viewer {
 public:
  explicit Viewer(RigSession& rig) : rig_(rig) {}

  template <typename Until>
  void watch(double at_most_s, Until until) {
    const double end_s = acquisition::host_now_s() + at_most_s;
    while (acquisition::host_now_s() < end_s && !until()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(33));
      LiveNews news = rig_.news();
      seen.append(news.more);
      for (auto& event : news.events) events.push_back(event);
      last = std::move(news);
    }
  }
  bool happened(const std::string& device, const std::string& kind) const {
    for (const auto& event : events)
      if (event.device == device && event.kind == kind) return true;
    return false;
  }

  LiveColumns seen;
  LiveNews last;
  std::vector<acquisition::Event> events;

 private:
  RigSession& rig_;
};

TEST(RigSession, ShowsRecordsAndGoesOnThroughAnUnplug) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "run.mcap";
  RigSession rig{RigOptions{}};
  Viewer view(rig);
  view.watch(20.0, [&] { return view.seen.loadcell_t_s.size() > 50; });
  ASSERT_GT(view.seen.loadcell_t_s.size(), 50u);
  EXPECT_TRUE(view.last.module.connected);

  rig.start_recording(file, "a test");
  EXPECT_THROW(rig.start_recording(folder.path() / "second.mcap", ""), std::runtime_error);
  rig.mark("now");
  view.watch(3.0, [] { return false; });
  ASSERT_TRUE(rig.command_board("unplug"));
  view.watch(20.0, [&] { return view.happened("loadcell", "unplugged"); });
  EXPECT_FALSE(view.last.loadcell.connected);
  const std::size_t before = view.seen.t_s.size();
  view.watch(1.0, [] { return false; });
  EXPECT_GT(view.seen.t_s.size(), before + 200);  // the module goes on
  ASSERT_TRUE(rig.command_board("plug"));
  view.watch(20.0, [&] { return view.happened("loadcell", "reconnected"); });
  EXPECT_TRUE(view.happened("loadcell", "reconnected"));
  const std::size_t heard = view.seen.loadcell_t_s.size();
  view.watch(20.0, [&] { return view.seen.loadcell_t_s.size() > heard + 50; });
  EXPECT_GT(view.seen.loadcell_t_s.size(), heard + 50);
  rig.stop_recording();
  view.watch(20.0, [&] { return !rig.recording().running; });
  EXPECT_EQ(rig.recording().failure, "");

  const auto recording = acquisition::read_recording(file);
  EXPECT_EQ(recording.cut_off, "");
  EXPECT_EQ(recording.recorded, "a test");
  EXPECT_GT(recording.module.t_s.size(), 1500u);
  EXPECT_EQ(recording.module.counts.lost, 0u);
  bool unplugged = false, marked = false;
  for (const auto& event : recording.events) {
    unplugged = unplugged || event.kind == "unplugged";
    marked = marked || event.text == "now";
  }
  EXPECT_TRUE(unplugged);
  EXPECT_TRUE(marked);
  for (const auto* t : {&view.seen.t_s, &view.seen.loadcell_t_s})
    EXPECT_TRUE(std::is_sorted(t->begin(), t->end()));
}

TEST(RigSession, ClosingItEndsARecordingWhole) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "run.mcap";
  {
    RigSession rig{RigOptions{}};
    Viewer view(rig);
    view.watch(20.0, [&] { return view.seen.t_s.size() > 100; });
    rig.start_recording(file, "");
    view.watch(1.0, [] { return false; });
  }
  EXPECT_EQ(acquisition::read_recording(file).cut_off, "");
  EXPECT_GT(acquisition::read_recording(file).module.t_s.size(), 300u);
}

TEST(RigSession, AKnownWeightReadsAsItIs) {
  RigSession rig{RigOptions{}};
  Viewer view(rig);
  const auto reading_under = [&](double newton) {
    EXPECT_TRUE(rig.command_board(std::string("hold ") + std::to_string(newton)));
    Weighing weighing(newton);
    std::optional<acquisition::KnownWeight> weight;
    view.watch(20.0, [&] { return (weight = weighing.take(view.last.counts)).has_value(); });
    return weight.value_or(acquisition::KnownWeight{});
  };
  view.watch(20.0, [&] { return !view.last.counts.empty(); });
  std::vector<acquisition::KnownWeight> weights;
  for (const double newton : {0.0, 9.80665, 19.6133}) weights.push_back(reading_under(newton));
  const auto calibration = acquisition::calibrate(weights);
  EXPECT_LT(calibration.residual_sd_n, 0.2);
  EXPECT_LT(std::abs(calibration.newton_per_count_ci95 / calibration.newton_per_count), 0.1);
}

TEST(RigSession, SaysInOneSentenceWhatCannotBeOpened) {
  RigOptions options;
  options.module = "nonsense";
  try {
    RigSession rig(options);
    ADD_FAILURE() << "nothing was said";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("nonsense"), std::string::npos);
  }
}

}  // namespace
}  // namespace searig::app
