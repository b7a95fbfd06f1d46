#include "app/report/html.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace searig::app {
namespace {

constexpr std::string_view style_sheet = R"(
:root{color-scheme:light dark;--page:#fff;--text:#1f2328;--soft:#5b636d;--rule:#d9dde2;--tint:#f3f5f8;--accent:#0072b2}
@media screen and (prefers-color-scheme:dark){:root{--page:#16191d;--text:#e6e8eb;--soft:#9aa4b0;--rule:#363c44;--tint:#1f242a;--accent:#5bb8f0}}
body{max-width:60rem;margin:2.5rem auto;padding:0 1.25rem;background:var(--page);color:var(--text);font:16px/1.55 system-ui,"DejaVu Sans",Helvetica,Arial,sans-serif}
h1{font-size:1.7rem;line-height:1.25;margin:0 0 1rem}
h2{font-size:1.2rem;margin:2.2rem 0 .6rem;border-bottom:1px solid var(--rule);padding-bottom:.25rem}
p{margin:.6rem 0}
.verdict{border-left:4px solid var(--accent);background:var(--tint);padding:.7rem 1rem;font-size:1.05rem}
dl{display:grid;grid-template-columns:repeat(auto-fit,minmax(11rem,1fr));gap:.8rem;margin:1.2rem 0}
dl div{background:var(--tint);border-radius:6px;padding:.6rem .9rem}
dt{color:var(--soft);font-size:.85rem}
dd{margin:0;font-size:1.2rem;font-weight:600;font-variant-numeric:tabular-nums}
table{border-collapse:collapse;margin:1rem 0;font-variant-numeric:tabular-nums}
caption{caption-side:bottom;text-align:left;color:var(--soft);font-size:.9rem;padding-top:.4rem}
th,td{padding:.35rem .9rem;text-align:right;border-bottom:1px solid var(--rule)}
th{border-bottom-width:2px;font-weight:600}
th:first-child,td:first-child{padding-left:0}
th:first-child,td:first-child,.words{text-align:left}
td{vertical-align:top}
figure{margin:1.4rem 0;break-inside:avoid}
figure svg{max-width:100%;height:auto}
.beside{display:grid;grid-template-columns:repeat(auto-fit,minmax(20rem,1fr));gap:1.5rem}
.beside h3{font-size:.9rem;color:var(--soft);margin:.4rem 0 0}
.beside p{margin:.2rem 0}
figcaption{color:var(--soft);font-size:.9rem}
pre{background:var(--tint);padding:.8rem 1rem;overflow-x:auto;font-size:.85rem;border-radius:6px}
@media print{body{max-width:none;margin:0;font-size:11pt}h2{break-after:avoid}tr,dl div{break-inside:avoid}}
)";

std::string element(std::string_view name, std::string_view text) {
  const std::string tag(name);
  return "<" + tag + ">" + escape(text) + "</" + tag + ">";
}

/// Numbers stand right, one under the other; sentences read from the left.
bool holds_sentences(const std::vector<std::vector<std::string>>& rows, std::size_t column) {
  return std::ranges::any_of(rows, [column](const std::vector<std::string>& row) {
    return column < row.size() && row[column].size() > 32;
  });
}

}  // namespace

HtmlReport::HtmlReport(std::string_view title) : title_(title) {}

void HtmlReport::heading(std::string_view text) {
  body_ += element("h2", text) + "\n";
}

void HtmlReport::paragraph(std::string_view text) {
  body_ += element("p", text) + "\n";
}

void HtmlReport::verdict(std::string_view text) {
  body_ += "<p class=\"verdict\">" + escape(text) + "</p>\n";
}

void HtmlReport::facts(const std::vector<std::pair<std::string, std::string>>& name_and_value) {
  body_ += "<dl>\n";
  for (const auto& [name, value] : name_and_value) {
    body_ += "<div>" + element("dt", name) + element("dd", value) + "</div>\n";
  }
  body_ += "</dl>\n";
}

void HtmlReport::table(const std::vector<std::string>& header,
                       const std::vector<std::vector<std::string>>& rows, std::string_view text) {
  body_ += "<table>\n";
  if (!text.empty()) body_ += element("caption", text) + "\n";
  std::vector<bool> words;
  for (std::size_t i = 0; i < header.size(); ++i) words.push_back(holds_sentences(rows, i));
  const auto add_row = [&](const std::string& tag, const std::vector<std::string>& cells) {
    body_ += "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      body_ += "<" + tag + (i < words.size() && words[i] ? " class=\"words\">" : ">") +
               escape(cells[i]) + "</" + tag + ">";
    }
    body_ += "</tr>";
  };
  body_ += "<thead>";
  add_row("th", header);
  body_ += "</thead>\n<tbody>\n";
  for (const auto& row : rows) {
    add_row("td", row);
    body_ += "\n";
  }
  body_ += "</tbody>\n</table>\n";
}

void HtmlReport::figure(const Plot& plot, std::string_view text, Size size) {
  body_ += "<figure>\n" + to_svg(plot, size);
  caption(text);
}

void HtmlReport::figure(const CellMap& map, std::string_view text) {
  body_ += "<figure>\n" + to_svg(map);
  caption(text);
}

void HtmlReport::beside(std::string_view left_heading, std::string_view left,
                        std::string_view right_heading, std::string_view right) {
  body_ += "<div class=\"beside\">\n<div>" + element("h3", left_heading) + element("p", left) +
           "</div>\n<div>" + element("h3", right_heading) + element("p", right) +
           "</div>\n</div>\n";
}

void HtmlReport::picture(const Plot& plot, Size size) {
  body_ += "<figure>\n" + to_svg(plot, size) + "</figure>\n";
}

void HtmlReport::figure_svg(std::string_view svg, std::string_view text) {
  body_ += "<figure>\n" + std::string(svg);
  caption(text);
}

void HtmlReport::code(std::string_view text) {
  body_ += element("pre", text) + "\n";
}

void HtmlReport::caption(std::string_view text) {
  body_ += "<figcaption>Figure " + std::to_string(++figures_) + ". " + escape(text) +
           "</figcaption>\n</figure>\n";
}

std::string HtmlReport::text() const {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n" +
         element("title", title_) + "\n<style>" + std::string(style_sheet) +
         "</style>\n</head>\n<body>\n" + element("h1", title_) + "\n" + body_ +
         "</body>\n</html>\n";
}

void HtmlReport::write(const std::filesystem::path& file) const {
  std::ofstream out(file, std::ios::binary);
  out << text();
  out.close();
  if (!out) throw std::runtime_error("The report " + file.string() + " cannot be written.");
}

}  // namespace searig::app
