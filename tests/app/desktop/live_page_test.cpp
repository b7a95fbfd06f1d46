// The live page on the simulated rig with its real firmware: looked at, clicked through, unplugged.
#include "app/desktop/live/live_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <cmath>

#include "acquisition/recording/recording.h"
#include "app/desktop/layout_description.h"
#include "app/desktop/live/connect_panel.h"
#include "app/desktop/live/live_plots.h"
#include "app/desktop/live/record_panel.h"
#include "app/rig/stepped_rig.h"
#include "tests/app/desktop/offscreen.h"
#include "tests/app/desktop/pixels.h"
#include "tests/temporary_folder.h"

namespace searig::app::desktop {
namespace {

/// Twelve seconds of the simulated rig in simulated time: the same each time.
const std::filesystem::path& recorded_rig() {
  static const TemporaryFolder folder;
  static const std::filesystem::path file = [] {
    const auto made = folder.path() / "rig.mcap";
    SteppedRig rig(made, "searig test");
    rig.run_until(12.0);
    rig.finish();
    return made;
  }();
  return file;
}

void click(MainWindow& window, const char* name) {
  auto* button = window.findChild<QPushButton*>(QString::fromLatin1(name));
  ASSERT_NE(button, nullptr) << name;
  ASSERT_TRUE(button->isVisible() && button->isEnabled()) << name;
  QTest::mouseClick(button, Qt::LeftButton);
}

std::string words(MainWindow& window, const char* name) {
  return describe_layout(window)["words"].value(name, "");
}

TEST(LivePage, CurvesAreWhereTheDataAre) {
  const auto window = shown_window();
  window->live().show_as_live(recorded_rig(), 12.0);
  settle();
  const Pixels pixels(*window);
  const LiveColumns& c = window->live().plots().columns();
  ASSERT_GT(c.t_s.size(), 5000u);
  int looked_at = 0, mirrored = 0;
  for (std::size_t i = c.t_s.size() / 4; i < c.t_s.size(); i += 100, ++looked_at) {
    EXPECT_TRUE(pixels.drawn("torque", c.t_s[i], c.torque_nm[i], Hue::blue)) << c.t_s[i];
    EXPECT_TRUE(pixels.drawn("stiffness", c.t_s[i], c.k_nm_per_rad[i], Hue::green)) << c.t_s[i];
    EXPECT_TRUE(pixels.drawn("weight", c.t_s[i], c.weight[i], Hue::purple)) << c.t_s[i];
    if (std::abs(c.torque_nm[i]) > 1.5)
      mirrored += pixels.drawn("torque", c.t_s[i], -c.torque_nm[i], Hue::blue) ? 1 : 0;
  }
  EXPECT_GT(looked_at, 30);
  EXPECT_LE(mirrored, 2);  // so the test can fail
  // Each regime's residuals in its colour.
  const auto& driving = c.residuals[std::size_t(estimator::Regime::driving)];
  ASSERT_GT(driving.t_s.size(), 20u);
  int seen = 0;
  for (std::size_t i = 0; i < driving.t_s.size(); ++i)
    seen += pixels.drawn("residual", driving.t_s[i], driving.nm[i], Hue::blue) ? 1 : 0;
  EXPECT_GT(seen, int(driving.t_s.size()) * 9 / 10);
}

TEST(LivePage, NothingIsCutInEitherTheme) {
  for (const bool dark : {false, true}) {
    const auto window = shown_window(dark);
    EXPECT_EQ(describe_layout(*window)["cut"].size(), 0u) << describe_layout(*window)["cut"];
    window->live().show_as_live(recorded_rig(), 12.0);
    settle();
    const auto layout = describe_layout(*window);
    EXPECT_EQ(layout["cut"].size(), 0u) << layout["cut"];
    for (const char* plot : {"torque", "residual", "weight", "stiffness"})
      EXPECT_GT(layout["plots"][plot]["height"].get<int>(), 50) << plot;
    EXPECT_EQ(layout["words"]["verdict"], "DATA TRUSTED");
  }
}

TEST(LivePage, SaysWhatToDoInsteadOfDoingNothing) {
  const auto window = shown_window();
  QTest::keyClick(window.get(), Qt::Key_R);
  EXPECT_NE(window->live().message().indexOf("Ctrl+R"), -1);
  QTest::keyClick(window.get(), Qt::Key_M);
  EXPECT_NE(window->live().message().indexOf("start one with R"), -1);
  window->live().choice().choose("nonsense", "sim:");
  QTest::keyClick(window.get(), Qt::Key_R, Qt::ControlModifier);
  wait_until(20.0, [&] { return window->live().message().contains("nonsense"); });
  EXPECT_NE(window->live().message().indexOf("nonsense"), -1)
      << window->live().message().toStdString();
  EXPECT_FALSE(window->live().connected());
}

TEST(LivePage, ConnectCalibrateRecordUnplugReplay) {
  const TemporaryFolder folder;
  const auto window = shown_window();
  LivePage& page = window->live();
  page.recorder().set_folder(folder.path() / "made when needed");
  QTest::keyClick(window.get(), Qt::Key_R, Qt::ControlModifier);
  wait_until(20.0, [&] { return page.connected() && page.plots().now_s() > 1.0; });
  ASSERT_TRUE(page.connected()) << page.message().toStdString();

  QTest::keyClick(window.get(), Qt::Key_C);
  auto* mass = window->findChild<QDoubleSpinBox*>("mass");
  auto* read = window->findChild<QPushButton*>("read");
  for (const double kg : {0.0, 1.0, 2.0, 3.0}) {
    mass->setValue(kg);
    click(*window, "read");
    wait_until(10.0, [&] { return read->isEnabled(); });
  }
  EXPECT_NE(words(*window, "fit").find("N per count"), std::string::npos) << words(*window, "fit");
  EXPECT_EQ(describe_layout(*window)["cut"].size(), 0u) << describe_layout(*window)["cut"];
  keep_picture(*window, "calibrate");
  click(*window, "save");
  wait_until(20.0, [&] { return !page.connected(); });
  wait_until(20.0, [&] { return page.connected() && page.plots().now_s() > 1.0; });
  ASSERT_TRUE(page.connected()) << page.message().toStdString();
  EXPECT_FALSE(page.rig()->options().calibration.empty());

  window->findChild<QLineEdit*>("name")->setText("a task");
  window->setFocus();
  QTest::keyClick(window.get(), Qt::Key_R);
  wait_until(10.0, [&] { return page.rig()->recording().seconds > 1.0; });
  QTest::keyClick(window.get(), Qt::Key_M);
  ASSERT_TRUE(page.rig()->command_board("unplug"));
  wait_until(10.0,
             [&] { return words(*window, "verdict").find("UNPLUGGED") != std::string::npos; });
  EXPECT_NE(words(*window, "verdict").find("LOAD CELL UNPLUGGED"), std::string::npos);
  keep_picture(*window, "unplugged");
  ASSERT_TRUE(page.rig()->command_board("plug"));
  wait_until(10.0,
             [&] { return words(*window, "verdict").find("UNPLUGGED") == std::string::npos; });
  wait_until(10.0, [&] { return page.rig()->recording().seconds > 6.0; });
  QTest::keyClick(window.get(), Qt::Key_R);
  wait_until(10.0, [&] { return !page.rig()->recording().running; });
  wait_until(1.0, [&] { return window->findChild<QPushButton*>("open recorded")->isVisible(); });
  click(*window, "open recorded");
  EXPECT_EQ(window->page_in_front().name(), "Replay");
  EXPECT_TRUE(describe_layout(*window)["plots"].contains("torque"));

  const auto recording =
      acquisition::read_recording(folder.path() / "made when needed/a task.mcap");
  EXPECT_EQ(recording.cut_off, "");
  EXPECT_TRUE(std::any_of(recording.events.begin(), recording.events.end(),
                          [](const auto& event) { return event.text == "mark 1"; }));
  EXPECT_EQ(recording.module.counts.lost, 0u);
}

TEST(LivePage, OnlyTheSimulatedModuleBringsAModelOfItsOwn) {
  const auto window = shown_window();
  const auto* model = window->findChild<QPushButton*>("model");
  EXPECT_EQ(model->text(), "its own");
  auto* module = window->findChild<QComboBox*>("module");
  module->setEditText("udp://127.0.0.1:9750");
  EXPECT_EQ(model->text(), "none");
  module->setCurrentIndex(0);
  EXPECT_EQ(model->text(), "its own");
}

TEST(LivePage, LeadsAlongATargetBesideTheMotionThatThereIs) {
  const auto window = shown_window();
  LivePage& page = window->live();
  estimator::PlannedMotion motion;
  motion.kind = estimator::PlannedMotion::Kind::sine;
  motion.seconds = 60.0;
  motion.amplitudes_rad = {0.3};
  motion.frequencies_hz = {0.2};
  motion.output_rad = 0.2;
  EXPECT_FALSE(page.lead(motion));
  page.connect_rig();
  wait_until(20.0, [&] { return page.connected() && page.plots().now_s() > 2.0; });
  ASSERT_TRUE(page.lead(motion)) << page.message().toStdString();
  wait_until(3.0, [&] { return page.message().contains("Keep on the target"); });
  EXPECT_NE(page.message().indexOf("R records"), -1) << page.message().toStdString();
  wait_until(10.0, [&] { return page.plots().now_s() > 6.0; });
  QTest::keyClick(window.get(), Qt::Key_Space);  // so that it stands still
  page.plots().draw();
  settle();
  EXPECT_EQ(describe_layout(*window)["cut"].size(), 0u) << describe_layout(*window)["cut"];
  keep_picture(*window, "follow");
  const Pixels pixels(*window);
  const LiveColumns& c = page.plots().columns();
  int seen = 0, looked_at = 0;
  for (std::size_t i = c.t_s.size() / 2; i + 10 < c.t_s.size(); i += 20, ++looked_at)
    seen += pixels.drawn("target", c.t_s[i], c.deflection_rad[i], Hue::blue) ? 1 : 0;
  EXPECT_GT(looked_at, 20);
  EXPECT_GT(seen, looked_at * 8 / 10);  // the lever's is drawn above
  QTest::keyClick(window.get(), Qt::Key_T);
  EXPECT_FALSE(describe_layout(*window)["plots"].contains("target"));
}

TEST(LivePage, ResizingAndClosingWhileRecordingLosesNothing) {
  const TemporaryFolder folder;
  {
    const auto window = shown_window();
    LivePage& page = window->live();
    page.recorder().set_folder(folder.path());
    page.connect_rig();
    wait_until(20.0, [&] { return page.connected() && page.plots().now_s() > 0.5; });
    ASSERT_TRUE(page.connected()) << page.message().toStdString();
    window->findChild<QLineEdit*>("name")->setText("closed");
    page.toggle_recording();
    for (int i = 0; i < 20; ++i) {
      window->resize(900 + 37 * i, 700 + 23 * (i % 7));
      QTest::qWait(50);
    }
    window->close();
  }
  const auto recording = acquisition::read_recording(folder.path() / "closed.mcap");
  EXPECT_EQ(recording.cut_off, "");
  EXPECT_GT(recording.module.t_s.size(), 300u);
  const auto& seq = recording.module.channel("seq");
  for (std::size_t i = 1; i < seq.size(); ++i) ASSERT_EQ(seq[i], seq[i - 1] + 1.0);
}

TEST(LivePage, PauseKeepsTheViewWhileTheDataGoOn) {
  const auto window = shown_window();
  LivePage& page = window->live();
  page.connect_rig();
  wait_until(20.0, [&] { return page.connected() && page.plots().now_s() > 1.0; });
  ASSERT_TRUE(page.connected()) << page.message().toStdString();
  QTest::keyClick(window.get(), Qt::Key_Space);
  const auto before = describe_layout(*window)["plots"]["torque"]["x"];
  const std::size_t size = page.plots().columns().t_s.size();
  QTest::qWait(1000);
  EXPECT_EQ(describe_layout(*window)["plots"]["torque"]["x"], before);
  EXPECT_GT(page.plots().columns().t_s.size(), size + 300);
}

}  // namespace
}  // namespace searig::app::desktop
