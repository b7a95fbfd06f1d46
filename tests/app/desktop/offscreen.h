// A window without a display, for tests that drive it and look at it.
#pragma once

#include <QApplication>
#include <QTest>
#include <memory>

#include "app/desktop/main_window.h"
#include "app/desktop/qt_messages.h"

namespace searig::app::desktop {

/// Qt's application is one for the whole process and has to be there before any widget.
inline QApplication& offscreen_application() {
  static const auto made = [] {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    static int count = 1;
    static char name[] = "desktop_test";
    static char* words[] = {name, nullptr};
    auto application = std::make_unique<QApplication>(count, words);
    qInstallMessageHandler(drop_noise);
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

}  // namespace searig::app::desktop
