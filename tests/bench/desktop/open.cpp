// searig-bench-open RECORDING: how long it takes until a recording is on screen, step by step,
// drawn without a display; and the longest time for which the window did not answer meanwhile.
#include <QApplication>
#include <QTimer>
#include <chrono>
#include <cstdio>
#include <ctime>

#include "app/desktop/main_window.h"
#include "app/desktop/qt_messages.h"
#include "app/desktop/replay/replay_page.h"

namespace {

using namespace searig::app::desktop;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Of all threads: what it costs where others keep the processor busy.
double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("searig-bench-open RECORDING\n", stderr);
    return 2;
  }
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler(drop_noise);
  QApplication application(argc, argv);
  MainWindow window{Theme(false)};
  window.show();
  QApplication::processEvents();

  double longest_s = 0.0;
  auto last = Clock::now();
  QTimer beat;  // the window answers whenever this does
  QObject::connect(&beat, &QTimer::timeout, [&] {
    longest_s = std::max(longest_s, seconds_since(last));
    last = Clock::now();
  });
  beat.start(5);
  const auto start = Clock::now();
  const double cpu_start = cpu_s();
  window.open_recording(argv[1]);
  while (!window.replay().session() && window.replay().message().isEmpty())
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  window.grab();
  const double seen_s = seconds_since(start), seen_cpu_s = cpu_s() - cpu_start;
  while (!window.replay().estimate_shown() && window.replay().busy())
    QApplication::processEvents(QEventLoop::WaitForMoreEvents);
  window.grab();
  const double begun_s = seconds_since(start);
  window.replay().wait();
  window.grab();
  if (!window.replay().session()) {
    std::fprintf(stderr, "%s\n", window.replay().message().toUtf8().constData());
    return 1;
  }
  std::printf("%zu samples of the module, %zu of the load cell\n",
              window.replay().session()->recording.module.t_s.size(),
              window.replay().session()->recording.loadcell.t_s.size());
  std::printf("measured torque on screen after %6.2f s, of the processor %6.2f s\n", seen_s,
              seen_cpu_s);
  std::printf("beginning of the estimate       %6.2f s\n", begun_s);
  std::printf("whole estimate on screen after  %6.2f s, of the processor %6.2f s\n",
              seconds_since(start), cpu_s() - cpu_start);
  std::printf("the window answered all the time but for %.0f ms at most\n", 1e3 * longest_s);
  return 0;
}
