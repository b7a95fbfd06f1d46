// A hundred connections of the window to the simulated rig with its real firmware.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "acquisition/recording/recording.h"
#include "app/desktop/live/connect_panel.h"
#include "app/desktop/live/live_page.h"
#include "app/desktop/live/live_plots.h"
#include "app/desktop/live/record_panel.h"
#include "tests/app/desktop/offscreen.h"
#include "tests/temporary_folder.h"

#ifdef __SANITIZE_ADDRESS__
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();  // gcc 12 ships no header of it
#endif

namespace searig::app::desktop {
namespace {

/// What a process holds, as /proc has it.
struct Held {
  long files = 0, threads = 0, memory_kb = 0;
};

Held held() {
  Held now;
  for ([[maybe_unused]] const auto& file : std::filesystem::directory_iterator("/proc/self/fd"))
    ++now.files;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == "Threads:") status >> now.threads;
    if (word == "VmRSS:") status >> now.memory_kb;
  }
#ifdef __SANITIZE_ADDRESS__
  // The process's own size would count what the sanitizer holds back of what was freed.
  now.memory_kb = static_cast<long>(__sanitizer_get_current_allocated_bytes() / 1024);
#endif
  return now;
}

void cycle(MainWindow& window, bool record) {
  LivePage& page = window.live();
  page.connect_rig();
  wait_until(20.0, [&] { return page.connected() && page.plots().now_s() > 0.3; });
  ASSERT_TRUE(page.connected()) << page.message().toStdString();
  if (record) {
    page.toggle_recording();
    wait_until(5.0, [&] { return page.rig()->recording().seconds > 1.5; });
  }
  page.disconnect_rig();  // a recording that runs is ended by it
  wait_until(20.0, [&] { return !page.closing(); });
  ASSERT_FALSE(page.closing());
}

TEST(Connections, AHundredLeaveNothingBehind) {
  const TemporaryFolder folder;
  const auto window = shown_window();
  window->live().recorder().set_folder(folder.path());
  for (int i = 0; i < 5; ++i) cycle(*window, true);
  const Held before = held();
  for (int i = 0; i < 100; ++i) cycle(*window, i % 10 == 0);
  const Held after = held();
  std::printf("100 connections: files %ld -> %ld, threads %ld -> %ld, memory %.1f -> %.1f MB\n",
              before.files, after.files, before.threads, after.threads, 1e-3 * before.memory_kb,
              1e-3 * after.memory_kb);
  EXPECT_EQ(after.files, before.files);
  EXPECT_LE(after.threads, before.threads);
  EXPECT_LT(after.memory_kb, before.memory_kb + 20'000);
  int whole = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder.path()))
    whole += acquisition::read_recording(file.path()).cut_off.empty() ? 1 : 0;
  EXPECT_EQ(whole, 15);
}

}  // namespace
}  // namespace searig::app::desktop
