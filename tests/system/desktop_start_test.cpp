// What the window says where it cannot be one: no display that answers, no font.
#ifdef SEARIG_HAS_DESKTOP
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/system/run_program.h"

namespace searig {
namespace {

/// The window's program through `env`, with these settings in place of its own.
Ran run_window(const std::string& settings, const std::string& arguments) {
  const TemporaryFolder folder;
  const auto err = folder.path() / "err";
  const std::string line = "env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM " + settings +
                           " " + SEARIG_BINARY_DIR + "/searig-desktop " + arguments + " 2>" +
                           err.string() + " </dev/null";
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, "", text_of(err)};
}

bool is_one_line(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n') == 1;
}

TEST(DesktopStart, SaysOfADisplayThatDoesNotAnswerThatItDoesNot) {
  const Ran ran = run_window("DISPLAY=:9173", "");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find(":9173 does not answer"), std::string::npos) << ran.err;
  EXPECT_TRUE(is_one_line(ran.err)) << ran.err;
}

TEST(DesktopStart, SaysThatNoFontIsInstalled) {
  const TemporaryFolder folder;
  const auto none = folder.write("fonts.conf", "<?xml version=\"1.0\"?><fontconfig></fontconfig>");
  const auto png = folder.path() / "never.png";
  const Ran ran =
      run_window("FONTCONFIG_FILE=" + none.string(), "--offscreen --screenshot " + png.string());
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find("No font is installed"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(png));
}

}  // namespace
}  // namespace searig
#endif
