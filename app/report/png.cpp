#include "app/report/png.h"

#include <cairo/cairo.h>

#include <cstdlib>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

#include "app/report/canvas.h"

namespace searig::app {
namespace {

constexpr double pi = std::numbers::pi;

const char* light_shade(std::string_view paint) {
  for (const auto& shade : hues) {
    if (shade.name == paint) return shade.light;
  }
  for (const auto& shade : {ground, grid, faint}) {
    if (shade.name == paint) return shade.light;
  }
  return hues[0].light;
}

class PngCanvas final : public Canvas {
 public:
  PngCanvas(Size size, double scale)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                            static_cast<int>(size.width * scale),
                                            static_cast<int>(size.height * scale))),
        cairo_(cairo_create(surface_.get())) {
    cairo_scale(cairo_.get(), scale, scale);
    cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
    rectangle(0, 0, size.width, size.height, "ground");
  }

  void line(double x1, double y1, double x2, double y2, std::string_view paint,
            Stroke stroke) override {
    static constexpr double dashed[] = {6, 4}, dotted[] = {2, 3};
    set_paint(paint);
    if (stroke == Stroke::dashed) cairo_set_dash(cairo_.get(), dashed, 2, 0);
    if (stroke == Stroke::dotted) cairo_set_dash(cairo_.get(), dotted, 2, 0);
    cairo_set_line_width(cairo_.get(), stroke == Stroke::thick ? 2.0 : 1.0);
    cairo_move_to(cairo_.get(), x1, y1);
    cairo_line_to(cairo_.get(), x2, y2);
    cairo_stroke(cairo_.get());
    cairo_set_dash(cairo_.get(), nullptr, 0, 0);
  }

  void rectangle(double x, double y, double width, double height, std::string_view paint,
                 double opacity = 1.0) override {
    set_paint(paint, opacity);
    cairo_rectangle(cairo_.get(), x, y, width, height);
    cairo_fill(cairo_.get());
  }

  void polyline(const Points& points, std::string_view paint) override {
    if (points.size() < 2) return dots(points, paint);
    set_paint(paint);
    cairo_set_line_width(cairo_.get(), 1.4);
    trace(points);
    cairo_stroke(cairo_.get());
  }

  void polygon(const Points& points, std::string_view paint, double opacity) override {
    if (points.size() < 3) return;
    set_paint(paint, opacity);
    trace(points);
    cairo_fill(cairo_.get());
  }

  void dots(const Points& points, std::string_view paint, double diameter = 3.0) override {
    set_paint(paint);
    for (const auto& [x, y] : points) {
      cairo_new_path(cairo_.get());
      cairo_arc(cairo_.get(), x, y, diameter / 2, 0, 2 * pi);
      cairo_fill(cairo_.get());
    }
  }

  void text(double x, double y, std::string_view words, Anchor anchor,
            std::string_view kind) override {
    set_font(kind);
    const double width = width_of(words);
    static constexpr double shares[] = {0.0, 0.5, 1.0};
    cairo_move_to(cairo_.get(), x - shares[static_cast<int>(anchor)] * width, y);
    cairo_show_text(cairo_.get(), std::string(words).c_str());
  }

  void text_upwards(double x, double y, std::string_view words) override {
    set_font({});
    cairo_save(cairo_.get());
    cairo_translate(cairo_.get(), x, y);
    cairo_rotate(cairo_.get(), -pi / 2);
    cairo_move_to(cairo_.get(), -0.5 * width_of(words), 0);
    cairo_show_text(cairo_.get(), std::string(words).c_str());
    cairo_restore(cairo_.get());
  }

  void begin_clip(double x, double y, double width, double height) override {
    cairo_save(cairo_.get());
    cairo_rectangle(cairo_.get(), x, y, width, height);
    cairo_clip(cairo_.get());
  }
  void end_clip() override { cairo_restore(cairo_.get()); }

  /// CAIRO_STATUS_SUCCESS where everything went well, drawing included.
  cairo_status_t write(const std::filesystem::path& file) {
    if (const auto drawn = cairo_status(cairo_.get())) return drawn;
    return cairo_surface_write_to_png(surface_.get(), file.c_str());
  }

 private:
  void set_paint(std::string_view paint, double opacity = 1.0) {
    const auto rgb = std::strtol(light_shade(paint) + 1, nullptr, 16);  // "#rrggbb"
    cairo_set_source_rgba(cairo_.get(), static_cast<double>((rgb >> 16) & 255) / 255,
                          static_cast<double>((rgb >> 8) & 255) / 255,
                          static_cast<double>(rgb & 255) / 255, opacity);
  }

  void set_font(std::string_view kind) {
    const bool title = kind == "t";
    set_paint(kind == "f" ? "faint" : "ink");
    cairo_select_font_face(cairo_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           title ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_.get(), title ? 14.0 : 12.0);
  }

  double width_of(std::string_view words) {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_.get(), std::string(words).c_str(), &extents);
    return extents.x_advance;
  }

  void trace(const Points& points) {
    cairo_new_path(cairo_.get());
    for (const auto& [x, y] : points) cairo_line_to(cairo_.get(), x, y);
  }

  template <auto release>
  struct Release {
    void operator()(auto* handle) const { release(handle); }
  };
  std::unique_ptr<cairo_surface_t, Release<cairo_surface_destroy>> surface_;
  std::unique_ptr<cairo_t, Release<cairo_destroy>> cairo_;
};

}  // namespace

void write_png(const Plot& plot, const std::filesystem::path& file, Size size, double scale) {
  PngCanvas canvas(size, scale);
  draw(canvas, plot, size);
  if (const auto status = canvas.write(file)) {
    throw std::runtime_error(file.string() +
                             ": cannot be written: " + cairo_status_to_string(status) + ".");
  }
}

}  // namespace searig::app
