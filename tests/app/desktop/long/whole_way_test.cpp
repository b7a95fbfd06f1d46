// From nothing to a named finding, as a newcomer goes: by what the window says, and by keys alone.
#include <QDoubleSpinBox>

#include "acquisition/recording/recording.h"
#include "app/desktop/diagnose/diagnose_page.h"
#include "app/desktop/live/live_page.h"
#include "app/desktop/live/live_plots.h"
#include "app/desktop/live/record_panel.h"
#include "tests/app/desktop/window_test.h"

namespace searig::app::desktop {
namespace {

constexpr double recorded_s = 40.0;

class WholeWay : public WindowTest {
 protected:
  LivePage& live() { return window_->live(); }
  /// The window has said that this key is the next step, so it is pressed.
  void press_as_told(const char* told, Qt::Key next, Qt::KeyboardModifiers with = Qt::NoModifier) {
    wait_until(15.0, [&] { return message().find(told) != std::string::npos; });
    ASSERT_NE(message().find(told), std::string::npos) << message();
    EXPECT_EQ(describe_layout(*window_)["cut"].size(), 0u) << describe_layout(*window_)["cut"];
    key(next, with);
  }
  void until_connected() {
    wait_until(20.0, [&] { return live().connected() && live().plots().now_s() > 3.0; });
    ASSERT_TRUE(live().connected()) << message();
  }
  void weigh(double kg) {
    child<QDoubleSpinBox>("mass").setValue(kg);
    click("read");
    auto& read = child<QPushButton>("read");
    wait_until(10.0, [&] { return read.isEnabled(); });
  }
  bool verdict_says(const char* what) { return words("verdict").find(what) != std::string::npos; }
  double seconds() { return live().rig()->recording().seconds; }
};

TEST_F(WholeWay, LeadsFromNothingToANamedFindingAndTheExtendedModel) {
  live().recorder().set_folder(folder_.path());
  press_as_told("Ctrl+R", Qt::Key_R, Qt::ControlModifier);
  until_connected();

  press_as_told("C calibrates", Qt::Key_C);
  EXPECT_NE(words("step").find("Take everything off"), std::string::npos) << words("step");
  for (const double kg : {0.0, 1.0, 2.0}) weigh(kg);
  EXPECT_NE(words("step").find("save it"), std::string::npos) << words("step");
  click("save");
  wait_until(20.0, [&] { return !live().connected(); });
  until_connected();

  press_as_told("R records", Qt::Key_R);
  wait_until(10.0, [&] { return seconds() > 5.0; });
  press_as_told("M marks", Qt::Key_M);
  wait_until(20.0, [&] { return seconds() > 15.0; });
  keep_picture(*window_, "way-record");
  ASSERT_TRUE(live().rig()->command_board("unplug"));
  wait_until(10.0, [&] { return verdict_says("UNPLUGGED"); });
  EXPECT_TRUE(verdict_says("LOAD CELL UNPLUGGED"));
  ASSERT_TRUE(live().rig()->command_board("plug"));
  wait_until(10.0, [&] { return !verdict_says("UNPLUGGED"); });
  EXPECT_FALSE(verdict_says("UNPLUGGED"));
  wait_until(60.0, [&] { return seconds() > recorded_s; });
  press_as_told("R stops", Qt::Key_R);
  wait_until(10.0, [&] { return !live().rig()->recording().running; });
  const auto file = live().rig()->recording().file;
  press_as_told("O opens", Qt::Key_O);

  window_->replay().wait();
  ASSERT_NE(window_->replay().session(), nullptr) << message();
  EXPECT_EQ(window_->page_in_front().name(), "Replay");
  keep_picture(*window_, "way-replay");
  press_as_told("Ctrl+3", Qt::Key_3, Qt::ControlModifier);
  press_as_told("Press D", Qt::Key_D);
  window_->diagnose().wait();
  const auto examined = window_->diagnose().examined();
  ASSERT_NE(examined, nullptr) << message();
  ASSERT_EQ(examined->diagnosis.verdict, estimator::Verdict::missing_physics) << words("verdict");
  // The twin's rubber softens, and gives way in time (estimator/twin/rubber_spring.h).
  EXPECT_EQ(examined->diagnosis.findings.front().effect.substr(0, 7), "spring.")
      << words("verdict");
  keep_picture(*window_, "way-finding");
  press_as_told("A accepts", Qt::Key_A);
  EXPECT_NE(message().find("D diagnoses again"), std::string::npos) << message();
  auto extended = file;
  extended.replace_extension(".extended.toml");
  EXPECT_TRUE(std::filesystem::exists(extended)) << extended;

  for (const char* name : {"run.csv", "run.mat", "finding.html", "finding.svg", "page.png"}) {
    window_->export_to(folder_.path() / name);
    window_->wait_for_export();
    EXPECT_GT(std::filesystem::file_size(folder_.path() / name), 1000u) << name;
  }
  const auto recording = acquisition::read_recording(file);
  EXPECT_EQ(recording.cut_off, "");
  EXPECT_EQ(recording.module.counts.lost, 0u);
  EXPECT_TRUE(std::ranges::any_of(recording.events,
                                  [](const auto& event) { return event.text == "mark 1"; }));
}

}  // namespace
}  // namespace searig::app::desktop
