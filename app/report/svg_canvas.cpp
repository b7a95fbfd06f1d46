#include "app/report/svg_canvas.h"

#include <cmath>
#include <cstdio>

#include "app/report/svg.h"

namespace searig::app {
namespace {

/// A tenth of a pixel is as fine as anyone sees, and keeps files small.
std::string px(double value) {
  char text[32];
  if (std::abs(value - std::round(value)) < 0.05) {
    std::snprintf(text, sizeof text, "%.0f", value);
  } else {
    std::snprintf(text, sizeof text, "%.1f", value);
  }
  return text;
}

std::string attribute(std::string_view name, double value) {
  return ' ' + std::string(name) + "=\"" + px(value) + "\"";
}

std::string colour(std::string_view what, std::string_view paint) {
  return ' ' + std::string(what) + "=\"var(--" + std::string(paint) + ")\"";
}

std::string join(const Points& points) {
  std::string out;
  for (const auto& [x, y] : points) out += px(x) + "," + px(y) + " ";
  if (!out.empty()) out.pop_back();
  return out;
}

/// The colours for light and dark; printing is always light. The same in every picture, so that it
/// does no harm when a page holds several.
std::string style_sheet() {
  const auto variables = [](auto pick) {
    std::string out;
    const auto add = [&](const Shades& shade) {
      out += std::string("--") + shade.name + ":" + pick(shade) + ";";
    };
    for (const auto& shade : hues) add(shade);
    for (const auto& shade : {ground, grid, faint}) add(shade);
    return out;
  };
  return ".searig{" + variables([](const Shades& s) { return s.light; }) +
         "font:12px system-ui,'DejaVu Sans',Helvetica,Arial,sans-serif}"
         ".searig text{fill:var(--ink)}.searig .t{font-weight:600;font-size:14px}"
         ".searig .f{fill:var(--faint)}"
         "@media screen and (prefers-color-scheme:dark){.searig{" +
         variables([](const Shades& s) { return s.dark; }) + "}}";
}

}  // namespace

SvgCanvas::SvgCanvas(Size size, std::string_view title) {
  const std::string width = std::to_string(size.width), height = std::to_string(size.height);
  out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"searig\" role=\"img\" viewBox=\"0 0 " +
         width + " " + height + "\" width=\"" + width + "\" height=\"" + height + "\">\n<title>" +
         escape(title) + "</title>\n<style>" + style_sheet() + "</style>\n";
  rectangle(0, 0, size.width, size.height, "ground");
}

void SvgCanvas::line(double x1, double y1, double x2, double y2, std::string_view paint,
                     Stroke stroke) {
  static constexpr const char* strokes[] = {"", "stroke-width=\"2\"", "stroke-dasharray=\"6 4\"",
                                            "stroke-dasharray=\"2 3\""};
  out_ += "<line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) +
          attribute("y2", y2) + colour("stroke", paint) + " " + strokes[static_cast<int>(stroke)] +
          "/>\n";
}

void SvgCanvas::rectangle(double x, double y, double width, double height, std::string_view paint,
                          double opacity) {
  char alpha[32];
  std::snprintf(alpha, sizeof alpha, " fill-opacity=\"%.3f\"", opacity);
  out_ += "<rect" + attribute("x", x) + attribute("y", y) + attribute("width", width) +
          attribute("height", height) + colour("fill", paint) + (opacity < 1.0 ? alpha : "") +
          "/>\n";
}

void SvgCanvas::polyline(const Points& points, std::string_view paint) {
  if (points.size() < 2) return dots(points, paint);
  out_ += "<polyline fill=\"none\" stroke-width=\"1.4\" stroke-linejoin=\"round\"" +
          colour("stroke", paint) + " points=\"" + join(points) + "\"/>\n";
}

void SvgCanvas::polygon(const Points& points, std::string_view paint, double opacity) {
  if (points.size() < 3) return;
  char alpha[48];
  std::snprintf(alpha, sizeof alpha, " fill-opacity=\"%.2f\"", opacity);
  out_ += "<polygon" + colour("fill", paint) + alpha + " points=\"" + join(points) + "\"/>\n";
}

void SvgCanvas::dots(const Points& points, std::string_view paint, double diameter) {
  if (points.empty()) return;
  out_ += "<path" + attribute("stroke-width", diameter) + " stroke-linecap=\"round\"" +
          colour("stroke", paint) + " d=\"";
  for (const auto& [x, y] : points) out_ += 'M' + px(x) + " " + px(y) + "h0";
  out_ += "\"/>\n";
}

void SvgCanvas::text(double x, double y, std::string_view words, Anchor anchor,
                     std::string_view kind) {
  static constexpr const char* names[] = {"start", "middle", "end"};
  out_ += "<text" + attribute("x", x) + attribute("y", y);
  if (anchor != Anchor::start) {
    out_ += std::string(" text-anchor=\"") + names[static_cast<int>(anchor)] + "\"";
  }
  if (!kind.empty()) out_ += " class=\"" + std::string(kind) + "\"";
  out_ += '>' + escape(words) + "</text>\n";
}

void SvgCanvas::text_upwards(double x, double y, std::string_view words) {
  out_ += "<text text-anchor=\"middle\" transform=\"translate(" + px(x) + " " + px(y) +
          ") rotate(-90)\">" + escape(words) + "</text>\n";
}

void SvgCanvas::begin_clip(double x, double y, double width, double height) {
  // Ids are global in a page: one made of what it says never means two things.
  const std::string id = 'c' + px(x) + "_" + px(y) + "_" + px(width) + "_" + px(height);
  out_ += "<clipPath id=\"" + id + "\"><rect" + attribute("x", x) + attribute("y", y) +
          attribute("width", width) + attribute("height", height) +
          "/></clipPath>\n<g clip-path=\"url(#" + id + ")\">\n";
}

void SvgCanvas::end_clip() {
  out_ += "</g>\n";
}

std::string SvgCanvas::finish() && {
  return std::move(out_) + "</svg>\n";
}

std::string escape(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace searig::app
