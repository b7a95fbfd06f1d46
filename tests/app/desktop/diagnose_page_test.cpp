#include "app/desktop/diagnose/diagnose_page.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/desktop/diagnose/guided_motion.h"
#include "app/desktop/plot/time_plot.h"
#include "app/desktop/replay/replay_page.h"
#include "tests/app/desktop/pixels.h"
#include "tests/app/desktop/window_test.h"
#include "tests/app/session/sample_recording.h"

namespace searig::app::desktop {
namespace {

using estimator::Verdict;

class DiagnosePageTest : public WindowTest {
 protected:
  void SetUp() override {
    make_sample_recording(path_);
    open(path_);
    key(Qt::Key_3, Qt::ControlModifier);
  }

  DiagnosePage& page() { return window_->diagnose(); }
  void find() {
    key(Qt::Key_D);
    page().wait();
    settle();
    ASSERT_NE(page().examined(), nullptr) << message();
  }

  std::filesystem::path path_ = folder_.path() / "sample";
};

TEST_F(DiagnosePageTest, NamesWhatTheModelLeavesOutAndAcceptsIt) {
  EXPECT_FALSE(child<QPushButton>("accept").isEnabled());
  find();
  const auto& d = page().examined()->diagnosis;
  ASSERT_EQ(d.verdict, Verdict::missing_physics);
  ASSERT_EQ(d.findings.size(), 1u);
  EXPECT_EQ(d.findings.front().effect, "spring.viscous");
  EXPECT_NE(words("verdict").find("damping"), std::string::npos) << words("verdict");
  EXPECT_NE(words("finding").find("spring.viscous"), std::string::npos);
  EXPECT_NE(page().message().indexOf("A accepts"), -1);

  keep_picture(*window_, "diagnose");

  key(Qt::Key_A);
  const auto file = path_ / "extended.toml";
  ASSERT_TRUE(std::filesystem::exists(file)) << page().message().toStdString();
  const auto model = find_model(path_, file);
  EXPECT_NEAR(*model->get("spring.viscous", "c_nm_s_per_rad"), sample_c, 0.05);
  find();  // with it
  EXPECT_EQ(page().examined()->diagnosis.verdict, Verdict::consistent) << words("verdict");
  EXPECT_FALSE(child<QPushButton>("accept").isEnabled());
}

TEST_F(DiagnosePageTest, TheDifferencesAreDrawnWhereTheyAre) {
  find();
  const auto& traces = page().examined()->diagnosis.traces;
  const double start_s = page().examined()->signals.module.t_s.front();
  const Pixels pixels(*window_);
  int looked_at = 0;
  for (std::size_t i = 7; i < traces.t_s.size(); i += 7) {  // the first stands on the edge
    const double before = traces.spring_before_nm[i];
    if (std::abs(before) < 0.2) continue;  // where nothing covers it
    ++looked_at;
    EXPECT_TRUE(pixels.drawn("residual", traces.t_s[i] - start_s, before, Hue::vermilion)) << i;
  }
  EXPECT_GT(looked_at, 20);
}

TEST_F(DiagnosePageTest, ReplayIsShadedWhereTheModelMissesMost) {
  find();
  window_->show_page("replay");
  const auto shaded = child<TimePlot>("torque").as_plot().shaded;
  const auto here = window_->diagnose().findChild<TimePlot*>("residual")->as_plot().shaded;
  ASSERT_FALSE(shaded.empty());
  ASSERT_EQ(shaded.size(), here.size());
  EXPECT_EQ(shaded.front().from, here.front().from);
  open(path_);
  EXPECT_TRUE(child<TimePlot>("torque").as_plot().shaded.empty());
}

TEST_F(DiagnosePageTest, TheAcceptedModelIsTheNextRunsOnReplay) {
  find();
  key(Qt::Key_A);
  key(Qt::Key_2, Qt::ControlModifier);
  key(Qt::Key_R);
  window_->replay().wait();
  EXPECT_NE(words("runs").find("extended.toml"), std::string::npos) << words("runs");
}

TEST_F(DiagnosePageTest, TheNextExperimentLeadsThroughItsMotion) {
  find();
  const auto& finding = page().examined()->diagnosis.findings.front();
  ASSERT_TRUE(finding.next_motion);
  key(Qt::Key_N);
  EXPECT_TRUE(child<QLabel>("steps").isVisible());
  page().guided().show_time(1.0);
  EXPECT_EQ(words("target"), "Begins in 2 s");
  page().guided().show_time(8.0);
  EXPECT_NE(words("target").find("Spring to"), std::string::npos) << words("target");
  keep_picture(*window_, "experiment");
  page().guided().show_time(4.0 + finding.next_motion->seconds);
  EXPECT_NE(words("target").find("Done"), std::string::npos);
  key(Qt::Key_Space);
  EXPECT_TRUE(page().guided().running());
  key(Qt::Key_N);
  EXPECT_FALSE(page().guided().running());
  EXPECT_FALSE(child<QLabel>("steps").isVisible());
}

TEST_F(DiagnosePageTest, StopsAndGoesOn) {
  key(Qt::Key_D);
  EXPECT_FALSE(child<QPushButton>("diagnose").isEnabled());
  key(Qt::Key_Escape);
  EXPECT_TRUE(child<QPushButton>("diagnose").isEnabled());
  page().wait();
  EXPECT_EQ(page().examined(), nullptr);
  find();
}

TEST_F(DiagnosePageTest, AnotherRecordingTakesTheFindingAway) {
  find();
  open(path_);
  window_->show_page("diagnose");
  EXPECT_EQ(page().examined(), nullptr);
  EXPECT_TRUE(words("verdict").empty());
}

}  // namespace
}  // namespace searig::app::desktop
