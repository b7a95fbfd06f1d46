#include "app/desktop/main_window.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QMenu>

#include "app/desktop/layout_description.h"
#include "app/desktop/live/live_page.h"
#include "app/desktop/replay/replay_page.h"
#include "tests/app/desktop/offscreen.h"

namespace searig::app::desktop {
namespace {

TEST(MainWindow, TurnsItsPagesByKey) {
  const auto window = shown_window();
  EXPECT_EQ(window->page_in_front().name(), "Live");
  QTest::keyClick(window.get(), Qt::Key_3, Qt::ControlModifier);
  EXPECT_EQ(window->page_in_front().name(), "Diagnose");
  QTest::keyClick(window.get(), Qt::Key_2, Qt::ControlModifier);
  EXPECT_EQ(window->page_in_front().name(), "Replay");
  QTest::keyClick(window.get(), Qt::Key_1, Qt::ControlModifier);
  EXPECT_EQ(window->page_in_front().name(), "Live");
}

TEST(MainWindow, AKeyIsThePagesThatIsInFront) {
  const auto window = shown_window();
  int live = 0, replay = 0;
  const auto count = [](Page& page, const QKeySequence& key, int& pressed) {
    for (QAction* action : page.menu()->actions())
      if (action->shortcut() == key)
        QObject::connect(action, &QAction::triggered, [&pressed] { ++pressed; });
  };
  count(window->page_in_front(), QKeySequence(Qt::Key_Home), live);
  window->show_page("replay");
  count(window->page_in_front(), QKeySequence(Qt::Key_Home), replay);
  QTest::keyClick(window.get(), Qt::Key_Home);
  EXPECT_EQ(live, 0);
  EXPECT_EQ(replay, 1);
  window->show_page("live");
  QTest::keyClick(window.get(), Qt::Key_Home);
  EXPECT_EQ(live, 1);
  EXPECT_EQ(replay, 1);
}

TEST(MainWindow, SaysOfARecordingThatIsNotThereThatItIsNot) {
  const auto window = shown_window();
  window->open_recording("/nowhere");
  window->replay().wait();
  EXPECT_EQ(window->replay().session(), nullptr);
  EXPECT_EQ(window->page_in_front().name(), "Replay");
  EXPECT_NE(window->page_in_front().message().indexOf("/nowhere"), -1);
}

TEST(LayoutDescription, TellsWhatIsVisibleAndWhatIsCut) {
  const auto window = shown_window();
  auto layout = describe_layout(*window);
  EXPECT_TRUE(layout["plots"].contains("torque"));
  EXPECT_EQ(layout["cut"].size(), 0u) << layout["cut"];
  EXPECT_NE(layout["words"]["hint"].get<std::string>().find("Ctrl+R"), std::string::npos);
  window->show_page("diagnose");
  layout = describe_layout(*window);
  EXPECT_TRUE(layout["plots"].contains("residual"));
  EXPECT_FALSE(layout["plots"].contains("torque"));
  auto* label = window->page_in_front().findChild<QWidget*>("hint");
  ASSERT_NE(label, nullptr);
  label->setFixedSize(20, 10);
  EXPECT_EQ(describe_layout(*window)["cut"].size(), 1u);
}

}  // namespace
}  // namespace searig::app::desktop
