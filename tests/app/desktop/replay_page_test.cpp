#include "app/desktop/replay/replay_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>

#include "app/desktop/plot/time_plot.h"
#include "app/desktop/replay/history_view.h"
#include "tests/app/desktop/pixels.h"
#include "tests/app/desktop/window_test.h"
#include "tests/app/session/sample_recording.h"

namespace searig::app::desktop {
namespace {

class ReplayPageTest : public WindowTest {
 protected:
  void SetUp() override {
    make_sample_recording(path_);
    open(path_);
    ASSERT_NE(page().session(), nullptr) << message();
  }

  ReplayPage& page() { return window_->replay(); }
  HistoryView& view() { return page().view(); }
  TimePlot& torque() { return *view().plots().front(); }
  /// Where the plot shows a time, on its canvas.
  QPoint at(double t_s) {
    const Range x = torque().x_range();
    const int width = torque().canvas().width();
    return {int(std::lround((t_s - x.low) / (x.high - x.low) * (width - 1))), 20};
  }

  std::filesystem::path path_ = folder_.path() / "sample";
};

TEST_F(ReplayPageTest, ShowsTheWholeRecordingOnceItIsOpen) {
  EXPECT_EQ(page().caption(), "sample");
  EXPECT_NEAR(view().range().low, 0.0, 1e-9);
  EXPECT_NEAR(view().range().high, sample_seconds, 0.1);
  EXPECT_NE(page().message().indexOf("Diagnose"), -1);  // what to do next
}

TEST_F(ReplayPageTest, AxesStayTogetherWhateverMovesThem) {
  key(Qt::Key_Plus);
  key(Qt::Key_Right);
  for (TimePlot* plot : view().plots()) {
    EXPECT_DOUBLE_EQ(plot->x_range().low, view().range().low);
    EXPECT_DOUBLE_EQ(plot->x_range().high, view().range().high);
  }
  EXPECT_NEAR(view().range().high - view().range().low, sample_seconds / 2, 0.1);
  auto& scrub = child<QScrollBar>("scrub");
  scrub.setValue(0);
  EXPECT_NEAR(view().range().low, 0.0, 1e-6);
  scrub.setValue(scrub.maximum());
  EXPECT_NEAR(view().range().high, sample_seconds, 0.1);
}

TEST_F(ReplayPageTest, ADragEnlargesWhatItSpansAndBackLeadsBack) {
  QWidget* canvas = &torque().canvas();
  QTest::mousePress(canvas, Qt::LeftButton, {}, at(10.0));
  QTest::mouseMove(canvas, at(15.0));
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, at(15.0));
  EXPECT_NEAR(view().range().low, 10.0, 0.1);
  EXPECT_NEAR(view().range().high, 15.0, 0.1);
  key(Qt::Key_Backspace);
  EXPECT_NEAR(view().range().high, sample_seconds, 0.1);
}

TEST_F(ReplayPageTest, CursorsTellValuesAndDifferences) {
  QWidget* canvas = &torque().canvas();
  QTest::mouseClick(canvas, Qt::LeftButton, {}, at(10.0));
  QTest::mouseClick(canvas, Qt::LeftButton, Qt::ShiftModifier, at(30.0));
  const Cursors& cursors = view().cursors();
  ASSERT_TRUE(cursors.a_s && cursors.b_s);
  EXPECT_NEAR(*cursors.a_s, 10.0, 0.05);
  EXPECT_NEAR(*cursors.b_s, 30.0, 0.05);
  const double a = std::stod(words("time_a")), b = std::stod(words("time_b"));
  EXPECT_NEAR(std::stod(words("time_difference")), b - a, 2e-3);
  // The load cell sees the damped spring; the nearest of its samples is what is said.
  const auto& loadcell = page().session()->signals.loadcell;
  const std::size_t i = std::size_t(std::lround(*cursors.a_s * 50.0));
  std::string said = words("measured_a");
  if (said.rfind("−", 0) == 0) said = "-" + said.substr(std::string("−").size());
  EXPECT_NEAR(std::stod(said), loadcell.torque_nm[i], 0.6);
  const double before = *cursors.a_s;
  key(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_GT(*view().cursors().a_s, before);
  key(Qt::Key_C);
  EXPECT_FALSE(view().cursors().a_s);
  EXPECT_EQ(words("time_a"), "–");
}

TEST_F(ReplayPageTest, RunsAgainWithOtherSettingsOverTheFirst) {
  child<QLineEdit>("initial_k").setText("90");
  key(Qt::Key_R);
  page().wait();
  EXPECT_NE(words("runs").find("online from k = 90"), std::string::npos) << words("runs");
  EXPECT_TRUE(child<QLabel>("second_torque_a").isVisible());
  view().set_cursors({2.0, 8.5});
  view().show_range({0.0, 12.0});
  settle();
  keep_picture(*window_, "replay");
  key(Qt::Key_X);
  EXPECT_EQ(words("runs").find("k = 90"), std::string::npos);
  EXPECT_FALSE(child<QLabel>("second_torque_a").isVisible());
}

/// Looked at where its torque is furthest from what the motor current says.
TEST_F(ReplayPageTest, TheSecondRunIsDrawnOverTheFirst) {
  child<QLineEdit>("initial_k").setText("90");
  key(Qt::Key_R);
  page().wait();
  const History run = run_estimator(*page().session(), {.initial_k_nm_per_rad = 90.0}).history;
  const auto apart_nm = [&](std::size_t i) {
    return std::abs(run.estimated_nm[i] - run.current_nm[i]);
  };
  std::size_t at = 400;  // it has come to rest
  for (std::size_t i = at; i < run.t_s.size(); ++i)
    if (apart_nm(i) > apart_nm(at)) at = i;
  view().show_range({run.t_s[at] - 0.1, run.t_s[at] + 0.1});
  settle();
  const Pixels pixels(*window_);
  const Range y = torque().y_range();
  const double px_nm = (y.high - y.low) / torque().canvas().height();
  int apart = 0, by_current = 0;
  for (std::size_t i = at - 18; i < at + 18; ++i) {
    const double t = run.t_s[i], k = run.stiffness_nm_per_rad[i];
    EXPECT_TRUE(pixels.drawn("torque", t, run.estimated_nm[i], Hue::vermilion)) << t;
    EXPECT_TRUE(pixels.drawn("stiffness", t, k, Hue::vermilion)) << t;
    if (apart_nm(i) < 6.0 * px_nm) continue;
    ++apart;
    by_current += pixels.drawn("torque", t, run.current_nm[i], Hue::vermilion) ? 1 : 0;
  }
  EXPECT_GT(apart, 20);
  EXPECT_LT(by_current, apart / 10);
}

TEST_F(ReplayPageTest, ResidualsStandInTheColourOfTheirRegime) {
  const auto run = run_estimator(*page().session(), {});
  view().show_range({5.0, 10.0});
  settle();
  const Pixels pixels(*window_);
  const Hue hues[] = {Hue::purple, Hue::blue, Hue::green};
  int looked_at = 0, seen = 0;
  for (const std::size_t regime : {0, 1, 2}) {
    const auto& residuals = run.residuals[regime];
    for (std::size_t i = 0; i < residuals.t_s.size(); ++i) {
      if (residuals.t_s[i] < 5.1 || residuals.t_s[i] > 9.9) continue;
      ++looked_at;
      seen += pixels.drawn("residual", residuals.t_s[i], residuals.nm[i], hues[regime]) ? 1 : 0;
    }
  }
  EXPECT_GT(looked_at, 100);
  EXPECT_GT(seen, looked_at * 9 / 10);
}

TEST_F(ReplayPageTest, SaysWhyAModelCannotBeUsed) {
  page().use_model(folder_.path() / "none.toml");
  key(Qt::Key_R);
  page().wait();
  EXPECT_NE(page().message().indexOf("none.toml"), -1) << page().message().toStdString();
  EXPECT_NE(page().session(), nullptr);
}

TEST_F(ReplayPageTest, WhatIsOpenStaysWhereTheNextCannotBeOpened) {
  window_->open_recording(folder_.path() / "nowhere");
  page().wait();
  EXPECT_NE(page().message().indexOf("nowhere"), -1);
  EXPECT_EQ(page().caption(), "sample");
}

TEST_F(ReplayPageTest, StopsWhenAsked) {
  key(Qt::Key_R);
  key(Qt::Key_Escape);
  page().wait();
  EXPECT_NE(page().message().indexOf("Stopped"), -1) << page().message().toStdString();
  EXPECT_FALSE(child<QLabel>("second_torque_a").isVisible());
}

}  // namespace
}  // namespace searig::app::desktop
