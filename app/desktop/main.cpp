// searig-desktop: the window. Exit 0 done, 1 the work failed, 2 wrong use.
#include <CLI/CLI.hpp>
#include <QApplication>
#include <QElapsedTimer>
#include <QRawFont>
#include <fstream>
#include <iostream>
#include <string>

#include "app/desktop/diagnose/diagnose_page.h"
#include "app/desktop/display.h"
#include "app/desktop/layout_description.h"
#include "app/desktop/live/live_page.h"
#include "app/desktop/live/live_plots.h"
#include "app/desktop/main_window.h"
#include "app/desktop/qt_messages.h"
#include "app/desktop/replay/replay_page.h"
#include "app/desktop/theme.h"

namespace {

using namespace searig::app::desktop;

struct Options {
  std::string recording, as_live;
  bool live = false;
  bool diagnose = false;
  double seconds = 20.0;
  bool offscreen = false;
  std::string screenshot;
  std::string layout;
  std::string page;
  std::string theme = "system";
  int width = 1280, height = 800;
};

void describe(CLI::App& app, Options& options) {
  app.set_version_flag("--version", SEARIG_VERSION);
  app.footer(
      "Examples:\n  searig-desktop recordings/r001\n"
      "  searig-desktop --live\n"
      "  searig-desktop --live --seconds 30 --offscreen --screenshot window.png");
  auto* recording = app.add_option("RECORDING", options.recording, "Recording folder to open");
  auto* live =
      app.add_flag("--live", options.live, "Connect the simulated rig")->excludes(recording);
  app.add_option("--as-live", options.as_live, "Show a recording as it looked live")
      ->excludes(recording)
      ->excludes(live);
  app.add_option("--seconds", options.seconds,
                 "With --as-live, or --live and --screenshot: how much of it has passed")
      ->check(CLI::Range(0.0, 3600.0));
  auto* picture =
      app.add_option("--screenshot", options.screenshot, "Write a picture of the window and leave");
  app.add_flag("--offscreen", options.offscreen, "Draw without a display")->needs(picture);
  app.add_option("--layout", options.layout,
                 "With --screenshot: write where plots and words are (JSON)")
      ->needs(picture);
  app.add_flag("--diagnose", options.diagnose,
               "With --screenshot: hold the recording against its model first")
      ->needs(picture)
      ->needs(recording);
  app.add_option("--page", options.page, "The page in front: live, replay or diagnose")
      ->check(CLI::IsMember({"live", "replay", "diagnose"}));
  app.add_option("--theme", options.theme, "light, dark or system")
      ->check(CLI::IsMember({"light", "dark", "system"}));
  app.add_option("--width", options.width, "Of the window, in pixels")
      ->check(CLI::Range(640, 8000));
  app.add_option("--height", options.height)->check(CLI::Range(480, 8000));
}

int fail(const std::string& sentence) {
  std::cerr << "searig-desktop: " << sentence << '\n';
  return 1;
}

/// Qt lists "Sans Serif" and its like even where no file stands behind them: then text is boxes.
bool has_font() {
  return !QRawFont::fromFont(QApplication::font()).fontTable("cmap").isEmpty();
}

Theme theme_of(const Options& options) {
  return options.theme == "system" ? Theme::of_system() : Theme(options.theme == "dark");
}

/// What was asked for; one sentence where it cannot be had.
std::string begin(MainWindow& window, const Options& options) {
  if (!options.recording.empty()) window.open_recording(options.recording);
  try {
    if (!options.as_live.empty()) window.live().show_as_live(options.as_live, options.seconds);
  } catch (const std::exception& error) {
    return error.what();
  }
  if (options.live) window.live().connect_rig();
  window.show_page(QString::fromStdString(options.page));
  return {};
}

/// Until the rig has run so long; it says itself why it does not.
bool watch_rig(LivePage& live, double seconds) {
  constexpr double until_connected_s = 20.0;
  QElapsedTimer since;
  since.start();
  const auto waited_s = [&] { return 1e-3 * double(since.elapsed()); };
  while (live.plots().now_s() < seconds && waited_s() < seconds + until_connected_s)
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  return live.plots().now_s() >= seconds;
}

/// Until the recording is read, and diagnosed where that was asked for; false where it cannot be.
bool work_through(MainWindow& window, const Options& options) {
  if (options.recording.empty()) return true;
  window.replay().wait();
  if (!window.replay().session()) return false;
  if (!options.diagnose) return true;
  window.diagnose().diagnose();
  window.diagnose().wait();
  return true;
}

int take_screenshot(MainWindow& window, const Options& options) {
  window.show();
  QApplication::processEvents();  // lays the window out at its size
  if (const std::string why = begin(window, options); !why.empty()) return fail(why);
  if (options.live && !watch_rig(window.live(), options.seconds))
    return fail(window.live().message().toStdString());
  if (!work_through(window, options)) return fail(window.replay().message().toStdString());
  for (int pass = 0; pass < 3; ++pass) QApplication::processEvents();  // layouts within layouts
  if (!window.grab().save(QString::fromStdString(options.screenshot))) {
    return fail("The picture " + options.screenshot + " cannot be written.");
  }
  if (!options.layout.empty()) {
    std::ofstream out(options.layout);
    out << describe_layout(window).dump(1) << '\n';
    if (!out.flush()) return fail("The file " + options.layout + " cannot be written.");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"The searig window: torque, trust and stiffness, live or from a recording"};
  describe(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (options.offscreen) qputenv("QT_QPA_PLATFORM", "offscreen");
  if (!options.offscreen && qEnvironmentVariableIsEmpty("DISPLAY") &&
      qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
      qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    return fail("There is no display (DISPLAY is not set); add --offscreen --screenshot FILE.png.");
  }
  if (!options.offscreen && !display_answers(argc, argv)) {
    return fail("The display " + qEnvironmentVariable("DISPLAY").toStdString() +
                " does not answer; start one, or add --offscreen --screenshot FILE.png.");
  }
  qInstallMessageHandler(drop_noise);
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QApplication application(argc, argv);
  if (!has_font()) {
    return fail("No font is installed, so no text would show; install one: fonts-dejavu-core.");
  }
  const Theme theme = theme_of(options);
  theme.apply(application);
  MainWindow window(theme);
  window.resize(options.width, options.height);
  if (!options.screenshot.empty()) return take_screenshot(window, options);

  window.continue_session(SessionStore(SessionStore::usual_place()));
  if (options.theme != "system") window.set_dark(theme.dark());
  window.show();
  if (options.recording.empty() && options.as_live.empty() && !options.live) window.reopen_last();
  if (const std::string why = begin(window, options); !why.empty()) std::cerr << why << '\n';
  return QApplication::exec();
}
