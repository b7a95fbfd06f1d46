// A window without a display, for tests that drive it and look at it.
#pragma once

#include <QApplication>
#include <QTest>
#include <memory>

#include "app/desktop/main_window.h"
#include "app/desktop/qt_messages.h"
#include "app/desktop/replay/replay_page.h"

namespace searig::app::desktop {

/// Qt's application is one for the whole process and has to be there before any widget.
inline QApplication& offscreen_application() {
  static const auto made = [] {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static int count = 1;
    static char name[] = "desktop_test";
    static char* words[] = {name, nullptr};
    qInstallMessageHandler(drop_noise);
    auto* application = new QApplication(count, words);  // Qt's statics may go before ours
    Theme(false).apply(*application);
    return application;
  }();
  return *made;
}

/// In front and laid out, so that keys reach it.
inline std::unique_ptr<MainWindow> shown_window(bool dark = false) {
  offscreen_application();
  auto window = std::make_unique<MainWindow>(Theme(dark));
  window->resize(1280, 800);
  window->show();
  QApplication::setActiveWindow(window.get());
  QApplication::processEvents();
  return window;
}

/// Layouts within layouts take a few rounds.
inline void settle() {
  for (int pass = 0; pass < 4; ++pass) QApplication::processEvents();
}

/// For whoever looks at them, and for docs/img: into the folder that SEARIG_PICTURES names.
inline void keep_picture(QWidget& window, const char* name) {
  const QString folder = qEnvironmentVariable("SEARIG_PICTURES");
  if (folder.isEmpty()) return;
  settle();
  window.grab().save(folder + "/desktop-" + name + ".png");
}

/// Lets the window live until something is so, at most that long.
template <typename Condition>
void wait_until(double at_most_s, Condition condition) {
  for (int i = 0; i < int(100.0 * at_most_s) && !condition(); ++i) QTest::qWait(10);
}

}  // namespace searig::app::desktop
