// searig-bench-desktop [FRAMES]: three plots of ten minutes at 1 kHz, drawn without a display while
// each frame brings the samples of 33 ms; milliseconds per frame. QT_SCALE_FACTOR=2 for HiDPI.
#include <QApplication>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <vector>

#include "app/desktop/plot/time_plot.h"
#include "app/desktop/qt_messages.h"

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

void measure(const char* what, const std::vector<TimePlot*>& plots, std::vector<Column>& columns,
             double span_s, int frames) {
  std::vector<double> ms, cpu;
  for (int frame = 0; frame < frames; ++frame) {
    const std::size_t size = columns[0].t_s.size() + per_frame;
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].grow(size, 3.0 + double(i));
    const auto start = Clock::now();
    const double start_cpu_ms = cpu_ms();
    const double now_s = columns[0].t_s.back();
    for (TimePlot* plot : plots) plot->show_range({now_s - span_s, now_s});
    QApplication::processEvents();  // paints
    cpu.push_back(cpu_ms() - start_cpu_ms);
    ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  std::printf("%-26s median %6.2f ms, 95th percentile %6.2f ms; of the processor %6.2f, %6.2f ms\n",
              what, share(ms, 0.5), share(ms, 0.95), share(cpu, 0.5), share(cpu, 0.95));
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qInstallMessageHandler(drop_noise);
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication application(argc, argv);
  const int frames = argc > 1 ? std::atoi(argv[1]) : 200;
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
  std::printf("three plots, %zu points each, %d x %d pixels, scale %g, %d frames\n", points,
              window.width(), window.height(), window.devicePixelRatioF(), frames);
  measure("the last ten minutes", plots, columns, 600.0, frames);
  measure("the last minute", plots, columns, 60.0, frames);
  measure("the last twenty seconds", plots, columns, 20.0, frames);
  return 0;
}
