#include "app/report/diagnosis_report.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/report/axis.h"
#include "app/report/diagnosis_bars.h"
#include "app/report/diagnosis_sections.h"
#include "app/report/diagnosis_sentences.h"
#include "app/report/diagnosis_words.h"
#include "app/report/quantity.h"

namespace searig::app {
namespace {

using estimator::Diagnosis;
using estimator::Finding;
using estimator::ParameterEstimate;
using estimator::Verdict;

std::string title_with(const Examined& examined) {
  std::vector<std::string> names;
  for (const Part& part : examined.parts) names.push_back(part.name);
  return "Diagnosis of " +
         (names.size() > 3 ? std::to_string(names.size()) + " recordings" : joined(names, ", "));
}

void write_facts(HtmlReport& report, const Examined& examined) {
  const Diagnosis& d = examined.diagnosis;
  std::vector<std::pair<std::string, std::string>> facts;
  std::vector<std::string> missing;
  for (const Finding& f : d.findings) missing.push_back(f.effect);
  if (!missing.empty()) facts.push_back({"missing", joined(missing, ", ")});
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
                     percent(u.located.share) +
                     " of the mismatch, and nothing in the catalogue explains it best.");
  }
  if (!d.undecidable.empty()) {
    report.heading("What this recording cannot decide");
    Rows rows;
    for (const auto& u : d.undecidable)
      rows.push_back({joined(u.effects, " or ", " or "), u.why, u.needs});
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
