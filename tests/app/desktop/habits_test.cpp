// What a user relies on everywhere: exports, the last session, keys, both themes.
#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QDropEvent>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QUrl>

#include "acquisition/recording/text_file.h"
#include "app/desktop/diagnose/diagnose_page.h"
#include "app/desktop/exports.h"
#include "app/desktop/replay/history_view.h"
#include "app/desktop/replay/replay_page.h"
#include "app/desktop/session_store.h"
#include "tests/app/desktop/window_test.h"
#include "tests/app/session/sample_recording.h"

namespace searig::app::desktop {
namespace {

class HabitsTest : public WindowTest {
 protected:
  void SetUp() override { make_sample_recording(path_); }
  void open() { WindowTest::open(path_); }
  std::string exported(const char* name) {
    const auto file = folder_.path() / name;
    window_->export_to(file);
    window_->wait_for_export();
    EXPECT_EQ(window_->notice().toStdString(), "Written: " + file.string());
    return file.string();
  }

  std::filesystem::path path_ = folder_.path() / "sample";
};

TEST_F(HabitsTest, ExportsThePageAndTheRecordingBehindIt) {
  open();
  const QImage picture(QString::fromStdString(exported("page.png")));
  EXPECT_EQ(picture.width(), 2 * window_->page_in_front().width());
  const std::string svg = acquisition::read_text_file(exported("page.svg"));
  for (const char* plot : {"Torque", "Trust in the motor current", "Spring stiffness"})
    EXPECT_NE(svg.find(std::string("<title>") + plot), std::string::npos) << plot;
  EXPECT_NE(svg.find("<polyline"), std::string::npos);
  const std::string csv = acquisition::read_text_file(exported("run.csv"));
  EXPECT_NE(csv.find("input_angle_rad"), std::string::npos);
  EXPECT_GT(std::ranges::count(csv, '\n'), 2000);  // 40 s at 50 Hz
  EXPECT_GT(std::filesystem::file_size(exported("run.mat")), 100'000u);
  EXPECT_GT(std::filesystem::file_size(exported("run.h5")), 100'000u);
}

TEST_F(HabitsTest, SaysWhatAnExportLacks) {
  window_->export_to(folder_.path() / "run.csv");
  EXPECT_NE(window_->notice().indexOf("Ctrl+O"), -1);
  open();
  window_->export_to(folder_.path() / "run.xyz");
  EXPECT_NE(window_->notice().indexOf(".svg"), -1);
  window_->export_to(folder_.path() / "run.html");
  EXPECT_NE(window_->notice().indexOf("Diagnose"), -1);
  window_->export_to("/nowhere/run.csv");
  window_->wait_for_export();
  EXPECT_NE(window_->notice().indexOf("/nowhere/run.csv"), -1) << window_->notice().toStdString();
}

TEST_F(HabitsTest, GoesOnWhereTheLastSessionEnded) {
  const QString file = QString::fromStdString((folder_.path() / "window.ini").string());
  window_->continue_session(SessionStore(file));
  open();
  window_->resize(1000, 700);
  window_->show_page("diagnose");
  window_->set_dark(true);
  window_->close();

  auto next = shown_window();
  next->continue_session(SessionStore(file));
  EXPECT_EQ(next->size(), QSize(1000, 700));
  EXPECT_EQ(next->page_in_front().name(), "Diagnose");
  next->reopen_last();
  EXPECT_EQ(next->page_in_front().name(), "Diagnose");
  next->replay().wait();
  EXPECT_EQ(next->replay().caption(), "sample");
  EXPECT_LT(QApplication::palette().color(QPalette::Window).lightness(), 128);
  next->set_dark(false);
}

TEST_F(HabitsTest, TakesUpTheViewOfTheRecordingThatWasOpen) {
  const QString file = QString::fromStdString((folder_.path() / "window.ini").string());
  window_->continue_session(SessionStore(file));
  open();
  window_->replay().view().show_range({3.25, 7.5});
  window_->replay().view().set_cursors({4.0, std::nullopt});
  window_->close();

  window_ = shown_window();
  window_->continue_session(SessionStore(file));
  window_->reopen_last();
  window_->replay().wait();
  const HistoryView& view = window_->replay().view();
  EXPECT_DOUBLE_EQ(view.range().low, 3.25);
  EXPECT_DOUBLE_EQ(view.range().high, 7.5);
  EXPECT_EQ(view.cursors().a_s, 4.0);
  EXPECT_FALSE(view.cursors().b_s);
  for (const char* words : {"", "1 2 3", "5 4 - -", "a b c d"}) window_->replay().take_view(words);
  EXPECT_DOUBLE_EQ(view.range().low, 3.25);
  open();  // anew, and another might be
  EXPECT_DOUBLE_EQ(view.range().low, 0.0);
}

/// Letters are a field's while it is written into, and a page's again after Return or Escape.
TEST_F(HabitsTest, KeysReachTheFieldsAndLeaveThem) {
  auto& name = child<QLineEdit>("name");
  auto& notes = child<QLineEdit>("notes");
  key(Qt::Key_N);
  ASSERT_TRUE(name.hasFocus());
  QTest::keyClicks(&name, "rmo n");
  EXPECT_EQ(name.text(), "rmo n");
  QTest::keyClick(&name, Qt::Key_Return);
  EXPECT_FALSE(name.hasFocus());
  key(Qt::Key_N, Qt::ShiftModifier);
  ASSERT_TRUE(notes.hasFocus());
  QTest::keyClicks(&notes, "Cold");
  QTest::keyClick(&notes, Qt::Key_Escape);
  EXPECT_EQ(notes.text(), "Cold");
  key(Qt::Key_R);  // the page's again
  EXPECT_NE(message().find("Connect first"), std::string::npos) << message();
  open();
  key(Qt::Key_K);
  auto& first_k = child<QLineEdit>("initial_k");
  ASSERT_TRUE(first_k.hasFocus());
  QTest::keyClicks(&first_k, "90");
  QTest::keyClick(&first_k, Qt::Key_Return);
  key(Qt::Key_R);
  window_->replay().wait();
  EXPECT_NE(words("runs").find("from k = 90"), std::string::npos) << words("runs");
}

TEST_F(HabitsTest, KeepsNothingWhereItIsNotAskedTo) {
  open();
  window_->close();
  EXPECT_TRUE(SessionStore().recent().isEmpty());
  SessionStore broken("/proc/no/such/place.ini");  // says nothing, keeps nothing
  broken.add_recent("a");
  EXPECT_EQ(broken.recent().size(), 1);
}

TEST_F(HabitsTest, RecentRecordingsAreListedOnceTheLastFirst) {
  SessionStore store;
  for (const char* name : {"a", "b", "a", "c"}) store.add_recent(name);
  EXPECT_EQ(store.recent(), (QStringList{"c", "a", "b"}));
  for (int i = 0; i < 20; ++i) store.add_recent(QString::number(i));
  EXPECT_EQ(store.recent().size(), 9);
}

TEST_F(HabitsTest, OpensWhatIsDroppedOnIt) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString((path_ / "recording.toml").string()))});
  QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  static_cast<QObject*>(window_.get())->event(&drop);
  window_->replay().wait();
  EXPECT_EQ(window_->replay().caption(), "sample");
}

TEST_F(HabitsTest, F1ListsEveryKeyAndAnyKeyClosesIt) {
  QTest::keyClick(window_.get(), Qt::Key_F1);
  auto* keys = window_->findChild<QLabel*>("keys");
  ASSERT_TRUE(keys && keys->isVisible());
  QApplication::processEvents();
  keep_picture(*window_, "keys");
  for (const char* words : {"Ctrl+O", "Ctrl+E", "Backspace", "Run the estimator again", "Accept"})
    EXPECT_NE(keys->text().indexOf(words), -1) << words;
  QTest::keyClick(keys->parentWidget(), Qt::Key_Escape);
  EXPECT_FALSE(keys->isVisible());
}

/// Two actions with one key would both do nothing.
TEST_F(HabitsTest, NoKeyMeansTwoThings) {
  for (const char* page : {"live", "replay", "diagnose"}) {
    window_->show_page(page);
    std::vector<std::string> seen;
    for (const QAction* action : window_->findChildren<QAction*>()) {
      const auto* menu = qobject_cast<QMenu*>(action->parent());
      const bool other_page = menu && dynamic_cast<Page*>(menu->parent()) &&
                              menu->parent() != &window_->page_in_front();
      if (other_page) continue;
      for (const QKeySequence& key : action->shortcuts()) {
        EXPECT_EQ(std::ranges::count(seen, key.toString().toStdString()), 0)
            << page << ": " << key.toString().toStdString();
        seen.push_back(key.toString().toStdString());
      }
    }
    EXPECT_GT(seen.size(), 10u);
  }
}

TEST_F(HabitsTest, NothingIsCutInEitherTheme) {
  open();
  for (const bool dark : {false, true}) {
    window_->set_dark(dark);
    for (const char* page : {"replay", "diagnose"}) {
      window_->show_page(page);
      QApplication::processEvents();
      const auto layout = describe_layout(*window_);
      EXPECT_TRUE(layout["cut"].empty()) << page << ": " << layout["cut"];
    }
  }
  window_->set_dark(false);
}

}  // namespace
}  // namespace searig::app::desktop
