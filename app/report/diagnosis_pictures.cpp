// The sections of the diagnosis report that show the mismatch: over time, over a channel, in maps.
#include <string>
#include <string_view>
#include <utility>

#include "app/report/diagnosis_map.h"
#include "app/report/diagnosis_plots.h"
#include "app/report/diagnosis_sections.h"
#include "estimator/physics/catalogue.h"

namespace searig::app {
namespace {

using estimator::Diagnosis;
using estimator::Verdict;

std::string channel_of(const Diagnosis& d) {
  if (!d.findings.empty()) {
    return estimator::find_effect(d.findings.front().effect)->about().channel;
  }
  if (d.unexplained && !d.unexplained->located.regions.empty()) {
    return d.unexplained->located.regions.front().channel;
  }
  return "deflection_rad";
}

}  // namespace

void write_pictures(HtmlReport& report, const Examined& examined) {
  const Diagnosis& d = examined.diagnosis;
  const bool changed = d.verdict != Verdict::consistent;
  const Against first = main_path(examined);
  const auto intervals = intervals_to_shade(examined);
  report.heading(changed ? "Before and after" : "What is left");
  report.figure(residual_over_time(examined, first, intervals),
                "What the load cell measured less what the simulation says. Every stretch of about "
                "ten seconds is predicted by a fit to the others.",
                {900, 320});
  if (changed) {
    report.figure(closer_look(examined, first, 8.0), "The eight seconds in which it matters most.",
                  {900, 280});
  }
  if (const auto plot = residual_over(examined, first, channel_of(d))) {
    report.figure(*plot, "The same differences over the channel in which they belong together.",
                  {900, 340});
  }
  const Against other = first == Against::spring ? Against::drive : Against::spring;
  if (has_path(examined, other)) {
    report.figure(residual_over_time(examined, other, {}),
                  other == Against::drive
                      ? "The motor current against the load cell, while the input moves: current "
                        "says nothing about torque while the train sticks."
                      : "The spring against the load cell.",
                  {900, 260});
  }
}

void write_maps(HtmlReport& report, const Examined& examined) {
  const Diagnosis& d = examined.diagnosis;
  const bool both = !d.findings.empty() || d.unexplained;
  report.heading("Where it differs");
  report.paragraph(
      std::string("Each strip is one channel from its lowest to its highest value; each cell is a "
                  "part of it with as many samples as the others. ") +
      (both ? "Colour before and grey after is what the finding explains; colour after is what it "
              "does not. "
            : "Grey is agreement. ") +
      "Grey cells are chance, the depth goes by the logarithm, and noise that wanders slowly "
      "colours the strip of time.");
  const std::pair<const char*, const char*> maps[] = {
      {"loadcell-spring", "Load cell less spring"},
      {"loadcell-drive", "Load cell less motor current"},
      {"drive-spring", "Motor current less spring"}};
  for (const auto& [residual, title] : maps) {
    if (!d.spring && std::string_view(residual).ends_with("spring")) continue;
    const std::string svg = mismatch_map(d.map, residual, title, both);
    if (!svg.empty()) report.figure_svg(svg, std::string(title) + ", part by part.");
  }
}

}  // namespace searig::app
