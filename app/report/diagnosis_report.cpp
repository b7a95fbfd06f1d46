#include "app/report/diagnosis_report.h"

#include <algorithm>

#include "app/report/axis.h"
#include "app/report/diagnosis_bars.h"
#include "app/report/diagnosis_map.h"
#include "app/report/diagnosis_words.h"
#include "app/report/quantity.h"
#include "estimator/physics/catalogue.h"

namespace searig::app {
namespace {

using estimator::Diagnosis;
using estimator::Finding;
using estimator::ParameterEstimate;
using estimator::Verdict;
using Rows = std::vector<std::vector<std::string>>;

std::string title_with(const Examined& examined) {
  std::string names;
  for (const Part& part : examined.parts) names += (names.empty() ? "" : ", ") + part.name;
  return "Diagnosis of " + (examined.parts.size() > 3
                                ? std::to_string(examined.parts.size()) + " recordings"
                                : names);
}

void write_facts(HtmlReport& report, const Examined& examined) {
  const Diagnosis& d = examined.diagnosis;
  std::vector<std::pair<std::string, std::string>> facts;
  std::string missing;
  for (const Finding& f : d.findings) missing += (missing.empty() ? "" : ", ") + f.effect;
  if (!missing.empty()) facts.push_back({"missing", missing});
  if (const auto& path = main_path(examined) == Against::spring ? d.spring : d.drive) {
    const bool only_numbers = d.verdict == Verdict::recalibrate && path->as_given;
    const double before = only_numbers ? *path->as_given : path->before;
    const std::string after = with_unit(path->after, "N·m", 2);
    const bool fell = d.verdict != Verdict::consistent;
    facts.push_back({fell ? "held-out error" : "error left",
                     fell ? figures(before, 2) + " → " + after : after});
    facts.push_back({"noise", with_unit(path->noise_floor, "N·m", 2)});
  }
  facts.push_back({"length", number(seconds_of(examined.parts), 0) + " s"});
  report.facts(facts);
}

std::string channel_of(const Diagnosis& d) {
  if (!d.findings.empty()) {
    return estimator::find_effect(d.findings.front().effect)->about().channel;
  }
  if (d.unexplained && !d.unexplained->located.regions.empty()) {
    return d.unexplained->located.regions.front().channel;
  }
  return "deflection_rad";
}

void write_parameters(HtmlReport& report, const std::vector<ParameterEstimate>& parameters) {
  Rows rows;
  for (const auto& p : in_order(parameters)) {
    const Rounded r = rounded(p.value, p.lower, p.upper);
    rows.push_back({p.name, r.value, is_measured(p) ? r.lower + " to " + r.upper : "given",
                    quantity_of(p.name).unit});
  }
  if (!rows.empty()) report.table({"parameter", "value", "95 % interval", "unit"}, rows);
}

void write_rivals(HtmlReport& report, const Finding& f) {
  std::vector<Bar> bars{{title_of(f.effect), f.probability, true}};
  Rows rows;
  double rest = 1.0 - f.probability;
  for (const auto& a : f.alternatives) {
    const std::string name = a.effect.empty() ? "something without a name" : title_of(a.effect);
    bars.push_back({name, a.probability});
    rest -= a.probability;
    if (!a.effect.empty() && !a.separated_by.empty()) {
      rows.push_back({a.effect, number(100.0 * a.probability, 0) + " %", a.separated_by});
    }
  }
  if (rest > 0.02) bars.push_back({"chance, or something not considered", rest});
  if (bars.size() == 1) {
    report.paragraph("No other explanation comes near: this one is " + how_sure(f.probability) +
                     ".");
    return;
  }
  report.figure_svg(probability_bars("How likely each explanation is", bars),
                    "The chance that this is what is missing, and what else it could be.");
  if (!rows.empty()) {
    report.table({"rival", "probability", "what would tell it apart"}, rows);
  }
}

void write_finding(HtmlReport& report, const Examined& examined, const Finding& f) {
  const Diagnosis& d = examined.diagnosis;
  const auto& about = estimator::find_effect(f.effect)->about();
  report.heading("Missing: " + about.title);
  report.paragraph("In the model file it is called " + f.effect +
                   ". The term is: " + about.equation + ".");
  report.paragraph("How to see it: " + about.looks_like + ".");
  const std::string place = where(f.located);
  report.paragraph(capital(improvement(d, f)) + ". That is " + number(100.0 * f.located.share, 0) +
                   " % of the mismatch" +
                   (place.empty() ? "." : "; most of it lies at " + place + "."));
  write_parameters(report, f.parameters);
  const std::string waves = waves_per_turn(f, examined.signals.gear_ratio);
  if (!waves.empty()) report.paragraph(waves);
  write_rivals(report, f);
}

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
      "Pale cells are chance, and noise that wanders slowly colours the strip of time.");
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

void write_errors(HtmlReport& report, const Diagnosis& d) {
  Rows rows;
  const auto add = [&](const char* name, const std::optional<estimator::PathErrors>& p) {
    if (!p) return;
    rows.push_back({name, p->as_given ? figures(*p->as_given) : "–", figures(p->before),
                    figures(p->after), figures(p->noise_floor)});
  };
  add("load cell less spring", d.spring);
  add("load cell less motor current", d.drive);
  report.heading("Errors");
  report.table(
      {"rms of the difference (N·m)", "as given", "refitted", "with what was missing", "noise"},
      rows,
      "As given: the model file as it came. Refitted: the same physics with the best "
      "numbers. All but the first are on data that no fit has seen.");
}

void write_numbers(HtmlReport& report, const Examined& examined) {
  const Diagnosis& d = examined.diagnosis;
  Rows rows;
  std::vector<Known> known;
  const auto add = [&](const ParameterEstimate& p) {
    const auto given = examined.given ? examined.given->get(p.effect, p.name) : std::nullopt;
    const Quantity q = quantity_of(p.name);
    if (!is_measured(p)) return;
    const Rounded r = rounded(p.value, p.lower, p.upper);
    rows.push_back({p.effect, q.name, given ? figures(*given) : "–", r.value,
                    r.lower + " to " + r.upper, q.unit});
    known.push_back({p.effect + " " + q.name, p.value, p.lower, p.upper, given});
  };
  for (const auto& p : in_order(d.numbers)) add(p);
  for (const Finding& f : d.findings)
    for (const auto& p : in_order(f.parameters)) add(p);
  if (rows.empty()) return;
  report.heading("Numbers");
  report.table({"term", "number", "in the model", "measured", "95 % interval", "unit"}, rows);
  const std::string svg = interval_plot("How well each number is known", known);
  if (!svg.empty()) {
    report.figure_svg(svg, "A cross outside the band is a number of the model that was off.");
  }
}

void write_open_questions(HtmlReport& report, const Diagnosis& d) {
  if (d.unexplained) {
    const auto& u = *d.unexplained;
    report.heading("What remains unexplained");
    const std::string place = where(u.located);
    report.paragraph(capital(u.what.empty() ? "a repeatable mismatch" : u.what) +
                     (place.empty() ? "." : ", at " + place + ".") + " It is " +
                     number(100.0 * u.located.share, 0) +
                     " % of the mismatch, and nothing in the catalogue explains it best.");
  }
  if (!d.undecidable.empty()) {
    report.heading("What this recording cannot decide");
    Rows rows;
    for (const auto& u : d.undecidable) {
      std::string effects;
      for (const auto& e : u.effects) effects += (effects.empty() ? "" : " or ") + e;
      rows.push_back({effects, u.why, u.needs});
    }
    report.table({"effect", "why not", "what would decide it"}, rows);
  }
  std::vector<std::string> next;
  for (const Finding& f : d.findings)
    if (!f.next_experiment.empty()) next.push_back(capital(f.next_experiment) + ".");
  if (next.empty()) return;
  report.heading("Next experiment");
  for (const auto& words : next) report.paragraph(words);
}

}  // namespace

HtmlReport diagnosis_report(const Examined& examined) {
  const Diagnosis& d = examined.diagnosis;
  HtmlReport report(title_with(examined));
  report.verdict(headline(d));
  write_facts(report, examined);
  for (const Finding& f : d.findings) write_finding(report, examined, f);
  write_pictures(report, examined);
  write_maps(report, examined);
  write_errors(report, d);
  write_numbers(report, examined);
  write_open_questions(report, d);
  if (!d.notes.empty()) report.heading("Notes");
  for (const auto& note : d.notes) report.paragraph(capital(note) + ".");
  report.heading(d.findings.empty() ? "The model with the best numbers"
                                    : "The model with what was missing");
  report.code(to_toml(d.extended));
  return report;
}

}  // namespace searig::app
