// The section of the diagnosis report that says what is missing.
#include <string>
#include <vector>

#include "app/report/axis.h"
#include "app/report/diagnosis_bars.h"
#include "app/report/diagnosis_sections.h"
#include "app/report/diagnosis_words.h"
#include "app/report/quantity.h"
#include "estimator/physics/catalogue.h"

namespace searig::app {
namespace {

using estimator::Diagnosis;
using estimator::Finding;
using estimator::ParameterEstimate;

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
      rows.push_back({a.effect, percent(a.probability), a.separated_by});
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

}  // namespace

void write_finding(HtmlReport& report, const Examined& examined, const Finding& f) {
  const Diagnosis& d = examined.diagnosis;
  const auto& about = estimator::find_effect(f.effect)->about();
  report.heading("Missing: " + about.title);
  report.paragraph("In the model file it is called " + f.effect +
                   ". The term is: " + about.equation + ".");
  report.paragraph("How to see it: " + about.looks_like + ".");
  const std::string place = where(f.located);
  report.paragraph(capital(improvement(d, f)) + ". That is " + percent(f.located.share) +
                   " of the mismatch" +
                   (place.empty() ? "." : "; most of it lies at " + place + "."));
  write_parameters(report, f.parameters);
  const std::string waves = waves_per_turn(f, examined.signals.gear_ratio);
  if (!waves.empty()) report.paragraph(waves);
  write_rivals(report, f);
}

}  // namespace searig::app
