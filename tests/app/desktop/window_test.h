// The window under test, its keys and its words.
#pragma once

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <memory>
#include <string>

#include "app/desktop/layout_description.h"
#include "tests/app/desktop/offscreen.h"
#include "tests/temporary_folder.h"

namespace searig::app::desktop {

class WindowTest : public testing::Test {
 protected:
  void key(Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
    QTest::keyClick(window_.get(), key, with);
  }
  /// Of the page in front.
  template <typename Widget>
  Widget& child(const char* name) {
    auto* found = window_->page_in_front().findChild<Widget*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name;
    return *found;
  }
  std::string words(const char* name) { return child<QLabel>(name).text().toStdString(); }
  void click(const char* name) {
    auto& button = child<QPushButton>(name);
    ASSERT_TRUE(button.isVisible() && button.isEnabled()) << name;
    QTest::mouseClick(&button, Qt::LeftButton);
  }
  /// What the page in front tells the user.
  std::string message() { return window_->page_in_front().message().toStdString(); }
  /// Opens a recording and waits until all of it is there, the estimate too.
  void open(const std::filesystem::path& recording) {
    window_->open_recording(recording);
    window_->replay().wait();
    settle();
  }

  TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_ = shown_window();
};

}  // namespace searig::app::desktop
