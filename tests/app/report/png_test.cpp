#include "app/report/png.h"

#include <cairo/cairo.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <stdexcept>

#include "tests/temporary_folder.h"

namespace searig::app {
namespace {

/// A PNG read back.
class Picture {
 public:
  explicit Picture(const std::filesystem::path& file)
      : surface_(cairo_image_surface_create_from_png(file.c_str())) {}
  ~Picture() { cairo_surface_destroy(surface_); }

  int width() const { return cairo_image_surface_get_width(surface_); }
  int height() const { return cairo_image_surface_get_height(surface_); }
  /// 0xrrggbb
  std::uint32_t at(int x, int y) const {
    const auto* row = cairo_image_surface_get_data(surface_) +
                      static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_);
    return reinterpret_cast<const std::uint32_t*>(row)[x] & 0xFFFFFF;
  }
  int count(std::uint32_t colour) const {
    int found = 0;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width(); ++x) found += at(x, y) == colour;
    }
    return found;
  }

 private:
  cairo_surface_t* surface_;
};

Plot straight_up() {
  Plot plot{.title = "Torque", .x_label = "Time (sec)", .y_label = "Torque (N·m)"};
  plot.series = {{"measured", {0, 10}, {-1, 1}, Style::line, Hue::blue}};
  plot.x_range = Range{0, 10};
  plot.y_range = Range{-1, 1};
  return plot;
}

TEST(Png, DrawsTheCurveInItsColourAndNothingElseInIt) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.png";
  write_png(straight_up(), file, {600, 300}, 1.0);
  const Picture picture(file);
  EXPECT_EQ(picture.width(), 600);
  EXPECT_EQ(picture.height(), 300);
  EXPECT_EQ(picture.at(0, 0), 0xFFFFFFu);
  EXPECT_GT(picture.count(0x0072b2), 100);  // blue, as the palette has it
  EXPECT_EQ(picture.count(0xd55e00), 0);    // no vermilion
}

TEST(Png, WritesTheWords) {
  const TemporaryFolder folder;
  Plot mute = straight_up();
  mute.title = mute.x_label = mute.y_label = mute.series[0].name = "";
  write_png(straight_up(), folder.path() / "said.png");
  write_png(mute, folder.path() / "mute.png");
  const std::uint32_t ink = 0x1f2328;
  EXPECT_GT(Picture(folder.path() / "said.png").count(ink), 200);
  EXPECT_EQ(Picture(folder.path() / "mute.png").count(ink), 0);
}

TEST(Png, AFileThatCannotBeWrittenIsSaid) {
  EXPECT_THROW(write_png(straight_up(), "/proc/nowhere/a.png"), std::runtime_error);
}

}  // namespace
}  // namespace searig::app
