#include "app/report/diagnosis_sentences.h"

#include "app/report/diagnosis_words.h"
#include "app/report/quantity.h"

namespace searig::app {
namespace {

using estimator::Diagnosis;
using estimator::Finding;
using estimator::ParameterEstimate;
using estimator::PathErrors;
using estimator::Verdict;

std::string unexplained_sentence(const estimator::Unexplained& u) {
  std::string out = "Unexplained";
  if (!u.what.empty()) out += ": " + u.what;
  if (const std::string place = where(u.located); !place.empty()) out += "; at " + place;
  return out + ".";
}

std::string parameter_text(const ParameterEstimate& p) {
  const Quantity q = quantity_of(p.name);
  if (!is_measured(p)) return q.name + " = " + with_unit(p.value, q.unit);
  const Rounded r = rounded(p.value, p.lower, p.upper);
  return q.name + " = " + r.value + (q.unit.empty() ? "" : " " + q.unit) + " (95 %: " + r.lower +
         " to " + r.upper + ")";
}

void describe(const Diagnosis& d, const Finding& f, std::vector<std::string>& out) {
  out.push_back(f.effect + ": " + title_of(f.effect) + ", " + how_sure(f.probability) + "; " +
                improvement(d, f) + ".");
  std::vector<std::string> numbers;
  for (const auto& p : in_order(f.parameters)) numbers.push_back(parameter_text(p));
  if (!numbers.empty()) out.push_back("  " + joined(numbers, ", ") + ".");
  if (const std::string place = where(f.located); !place.empty()) {
    out.push_back("  It shows most at " + place + ".");
  }
  for (const auto& a : f.alternatives) {
    if (a.probability < 0.005) continue;
    const std::string name =
        a.effect.empty() ? "something without a name" : title_of(a.effect) + " (" + a.effect + ")";
    out.push_back("  It could also be " + name + ": " + percent(a.probability) +
                  (a.separated_by.empty() ? "." : ". To tell: " + a.separated_by + "."));
  }
}

}  // namespace

std::vector<std::string> moved_numbers(const Diagnosis& d,
                                       const std::optional<estimator::Model>& given) {
  std::vector<std::string> out;
  if (d.verdict == Verdict::consistent) return out;
  for (const auto& p : d.numbers) {
    const auto was = given ? given->get(p.effect, p.name) : std::nullopt;
    if (!was || !is_measured(p) || p.allows(*was)) continue;
    out.push_back(p.effect + " " + parameter_text(p) + ", and the model had " + figures(*was));
  }
  return out;
}

std::vector<std::string> sentences(const Diagnosis& d,
                                   const std::optional<estimator::Model>& given) {
  std::vector<std::string> out{headline(d)};
  for (const Finding& f : d.findings) describe(d, f, out);
  if (d.unexplained) out.push_back(unexplained_sentence(*d.unexplained));
  const auto error_line = [&](const char* name, const std::optional<PathErrors>& p) {
    if (!p) return;
    out.push_back(std::string(name) + ": " +
                  (p->as_given ? figures(*p->as_given) + " as given, " : "") + figures(p->before) +
                  " refitted, " + figures(p->after) + " explained, noise " +
                  with_unit(p->noise_floor, "N·m") + ".");
  };
  error_line("Load cell against spring, rms", d.spring);
  error_line("Load cell against motor current, rms", d.drive);
  for (const auto& moved : moved_numbers(d, given)) out.push_back("Off: " + moved + ".");
  for (const auto& u : d.undecidable) {
    out.push_back("Cannot be decided from this: " + joined(u.effects, " or ") + ": " + u.why +
                  ". It needs: " + u.needs + ".");
  }
  for (const Finding& f : d.findings) {
    if (!f.next_experiment.empty()) {
      out.push_back("Next experiment: " + capital(f.next_experiment) + ".");
      break;
    }
  }
  return out;
}

}  // namespace searig::app
