#include "app/desktop/exports.h"

#include <QPainter>
#include <QPixmap>
#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include "acquisition/recording/text_file.h"
#include "app/desktop/plot/time_plot.h"
#include "app/export/export_recording.h"
#include "app/report/svg.h"
#include "app/session/read_with_model.h"

namespace searig::app::desktop {
namespace {

constexpr double finer = 2.0;
constexpr Size drawing_size{1000, 320};  // of each plot

constexpr std::array<std::pair<const char*, ExportKind>, 7> endings{{
    {".png", ExportKind::picture},
    {".svg", ExportKind::drawing},
    {".csv", ExportKind::csv},
    {".mat", ExportKind::mat},
    {".h5", ExportKind::hdf5},
    {".hdf5", ExportKind::hdf5},
    {".html", ExportKind::report},
}};

}  // namespace

ExportKind export_kind(const std::filesystem::path& file) {
  for (const auto& [ending, kind] : endings)
    if (file.extension() == ending) return kind;
  return ExportKind::none;
}

void save_picture(QWidget& view, const std::filesystem::path& file) {
  QPixmap picture(view.size() * finer);
  picture.setDevicePixelRatio(finer);
  view.render(&picture);
  if (!picture.save(QString::fromStdString(file.string()), "PNG"))
    throw std::runtime_error("The picture " + file.string() +
                             " cannot be written; choose another folder.");
}

void save_drawing(const QWidget& view, const std::filesystem::path& file) {
  std::vector<std::pair<int, Plot>> plots;  // by how far down they are
  for (const QWidget* widget : view.findChildren<QWidget*>())
    if (const auto* plot = dynamic_cast<const TimePlot*>(widget); plot && plot->isVisible())
      plots.emplace_back(plot->mapTo(&view, QPoint(0, 0)).y(), plot->as_plot());
  if (plots.empty())
    throw std::runtime_error("There is no plot in view to draw; a picture (.png) shows it all.");
  std::ranges::stable_sort(plots, {}, &std::pair<int, Plot>::first);
  std::vector<Plot> in_order;
  for (auto& [y, plot] : plots) in_order.push_back(std::move(plot));
  acquisition::write_text_file(file, to_svg(in_order, drawing_size));
}

void save_recording(const std::filesystem::path& recording, ExportKind kind,
                    const std::filesystem::path& file) {
  const auto read = read_with_model(recording);
  const Clocks clocks = clocks_of(read);
  const auto contents = acquisition::exchange::contents_of(read, clocks.loadcell, clocks.devices);
  const char* format = kind == ExportKind::mat ? "mat" : kind == ExportKind::hdf5 ? "hdf5" : "csv";
  // Whoever chose the name has been asked about what is there.
  export_recording(read, clocks, contents, {.format = format, .overwrite = true}, file,
                   SEARIG_PROGRAM);
}

}  // namespace searig::app::desktop
