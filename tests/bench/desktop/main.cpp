// searig-bench-desktop [FRAMES [SECONDS]]: what a frame costs with ten minutes of 1 kHz, while each
// frame brings the samples of 33 ms; then the whole window recording so many seconds at 1 kHz.
// Without a display. QT_SCALE_FACTOR=2 for HiDPI.
#include <QApplication>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "app/desktop/live/connect_panel.h"
#include "app/desktop/live/live_page.h"
#include "app/desktop/live/live_plots.h"
#include "app/desktop/live/record_panel.h"
#include "app/desktop/main_window.h"
#include "app/desktop/plot/time_plot.h"
#include "app/desktop/qt_messages.h"
#include "tests/temporary_folder.h"

namespace {

using namespace searig::app;
using namespace searig::app::desktop;
using Clock = std::chrono::steady_clock;

constexpr std::size_t points = 600'000, per_frame = 33;
constexpr double rate_hz = 1000.0;

/// A motion with the noise of a sensor, as far as it has been drawn.
struct Column {
  std::vector<double> t_s, y;
  std::mt19937_64 random{1};

  void grow(std::size_t to, double frequency) {
    std::normal_distribution<double> noise(0.0, 0.1);
    for (std::size_t i = t_s.size(); i < to; ++i) {
      t_s.push_back(double(i) / rate_hz);
      y.push_back(5.0 * std::sin(frequency * t_s.back()) + noise(random));
    }
  }
};

/// Of all threads of this process: what a frame costs where others keep the processor busy.
double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

double share(std::vector<double>& values, double at) {
  std::sort(values.begin(), values.end());
  return values[std::size_t(at * double(values.size() - 1))];
}

/// Milliseconds of each frame, on the wall and of the processor.
class Frames {
 public:
  template <typename Frame>
  void take(Frame frame) {
    const auto start = Clock::now();
    const double start_cpu_ms = cpu_ms();
    frame();
    QApplication::processEvents();  // paints
    cpu_.push_back(cpu_ms() - start_cpu_ms);
    wall_.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  void print(const char* what) {
    std::printf("%-26s median %6.2f ms, 95th percentile %6.2f ms; of the processor %6.2f, %6.2f\n",
                what, share(wall_, 0.5), share(wall_, 0.95), share(cpu_, 0.5), share(cpu_, 0.95));
  }

 private:
  std::vector<double> wall_, cpu_;
};

/// Three plots, and nothing else.
void measure_plots(int frames) {
  QWidget window;
  window.resize(1280, 800);
  auto* layout = new QVBoxLayout(&window);
  std::vector<TimePlot*> plots;
  std::vector<Column> columns(3);
  for (Column& column : columns) {
    column.grow(points, 3.0 + double(plots.size()));
    auto* plot = new TimePlot("Torque", "torque (N·m)", &window);
    plot->add_curve("measured", Hue::blue);
    plot->set_data(0, &column.t_s, &column.y);
    plot->set_theme(Theme(false));
    layout->addWidget(plot);
    plots.push_back(plot);
  }
  window.show();
  QApplication::processEvents();
  std::printf("three plots, %zu points each, %d x %d, scale %g\n", points, window.width(),
              window.height(), window.devicePixelRatioF());
  for (const double span_s : {600.0, 60.0, 20.0}) {
    Frames measured;
    for (int frame = 0; frame < frames; ++frame) {
      const std::size_t size = columns[0].t_s.size() + per_frame;
      for (std::size_t i = 0; i < columns.size(); ++i) columns[i].grow(size, 3.0 + double(i));
      const double now_s = columns[0].t_s.back();
      measured.take([&] {
        for (TimePlot* plot : plots) plot->show_range({now_s - span_s, now_s});
      });
    }
    measured.print(("  the last " + std::to_string(int(span_s)) + " s").c_str());
  }
}

/// As a rig would send them: [from, to) of the telemetry, the load cell at 50 Hz, so much later.
LiveNews news_of(std::size_t from, std::size_t to, double later_s = 0.0) {
  static std::mt19937_64 random(2);
  std::normal_distribution<double> noise(0.0, 0.05);
  LiveNews news;
  LiveColumns& c = news.more;
  for (std::size_t i = from; i < to; ++i) {
    const double t = later_s + double(i) / rate_hz, torque = 5.0 * std::sin(3.0 * t);
    c.t_s.push_back(t);
    c.torque_nm.push_back(torque + noise(random));
    c.low_nm.push_back(torque - 0.3);
    c.high_nm.push_back(torque + 0.3);
    c.clock_low_nm.push_back(torque - 0.5);
    c.clock_high_nm.push_back(torque + 0.5);
    c.weight.push_back(std::abs(std::sin(t)));
    c.k_nm_per_rad.push_back(40.0 + noise(random));
    c.k_low_nm_per_rad.push_back(39.0);
    c.k_high_nm_per_rad.push_back(41.0);
    c.deflection_rad.push_back(torque / 40.0);
    c.output_angle_rad.push_back(0.0);
    if (i % 20 != 0) continue;
    c.loadcell_t_s.push_back(t);
    c.loadcell_nm.push_back(torque + noise(random));
    auto& residuals = c.residuals[i / 2000 % c.residuals.size()];
    residuals.t_s.push_back(t);
    residuals.nm.push_back(noise(random));
  }
  news.now_s = later_s + double(to) / rate_hz;
  return news;
}

/// The live page's four plots with their bands and regimes, ten minutes of them kept.
void measure_live_plots(int frames) {
  LivePlots plots;
  plots.resize(988, 680);
  plots.set_theme(Theme(false));
  plots.show();
  LiveNews first = news_of(0, points);
  plots.take(first);
  std::printf("the live page's four plots, %zu samples kept\n", points);
  std::size_t at = points;
  for (const bool all : {true, false}) {
    Frames measured;
    if (all)
      plots.show_all();
    else
      for (int i = 0; i < 5; ++i) plots.zoom(0.5);
    for (int frame = 0; frame < frames; ++frame, at += per_frame) {
      LiveNews news = news_of(at, at + per_frame);
      measured.take([&] {
        plots.take(news);
        plots.draw();
      });
    }
    measured.print(all ? "  the last 600 s" : "  the last 19 s");
  }
}

template <typename Until>
void live_until(Until until) {
  while (!until()) QApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

void watch_recording(const LivePage& page, double seconds, const char* in_view) {
  const double before_s = page.newest_host_s();
  live_until([&] { return page.newest_host_s() != before_s; });
  const double start_cpu_ms = cpu_ms(), start_s = searig::acquisition::host_now_s();
  std::vector<double> late_ms;
  double shown_s = page.newest_host_s();
  live_until([&] {
    if (page.newest_host_s() != shown_s) {
      QApplication::processEvents();  // paints
      // The first sample that the frame before did not have came right behind its newest.
      late_ms.push_back(1e3 * (searig::acquisition::host_now_s() - shown_s));
      shown_s = page.newest_host_s();
    }
    return searig::acquisition::host_now_s() > start_s + seconds;
  });
  const double passed_s = searig::acquisition::host_now_s() - start_s;
  std::printf(
      "recording at 1 kHz for %.0f s, the last %s in view: %.1f frames a second, %.1f %% of a "
      "core\n",
      passed_s, in_view, double(late_ms.size()) / passed_s,
      0.1 * (cpu_ms() - start_cpu_ms) / passed_s);
  std::printf(
      "  a sample is drawn at most %.0f ms after its arrival in half of the frames, "
      "%.0f ms in 95 %%, %.0f ms in all\n",
      share(late_ms, 0.5), share(late_ms, 0.95), share(late_ms, 1.0));
}

/// The whole window, recording the simulated rig with its real firmware at 1 kHz: with the last
/// 20 s in view, then with ten minutes, of which all but the first seconds are given to it.
void measure_recording(double seconds) {
  const searig::TemporaryFolder folder;
  MainWindow window{Theme(false)};
  window.show();
  LivePage& page = window.live();
  page.recorder().set_folder(folder.path());
  DeviceOptions simulation;
  simulation.module_rate_hz = rate_hz;
  page.choice().set_simulation(simulation);
  page.connect_rig();
  live_until([&] { return page.connected() && page.plots().now_s() > 3.0; });
  page.toggle_recording();
  watch_recording(page, seconds, "20 s");
  LivePlots& plots = page.plots();
  const double now_s = plots.now_s();
  plots.clear();
  LiveNews history = news_of(0, points, now_s - double(points) / rate_hz);
  plots.take(history);
  plots.show_all();
  watch_recording(page, seconds, "10 min");
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler(drop_noise);
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication application(argc, argv);
  Theme(false).apply(application);
  const int frames = argc > 1 ? std::atoi(argv[1]) : 200;
  const double seconds = argc > 2 ? std::atof(argv[2]) : 30.0;
  measure_plots(frames);
  measure_live_plots(frames);
  if (seconds > 0.0) measure_recording(seconds);
  return 0;
}
