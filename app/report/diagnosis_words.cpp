#include "app/report/diagnosis_words.h"

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"
#include "app/report/quantity.h"
#include "estimator/physics/catalogue.h"

namespace searig::app {
namespace {

using estimator::Diagnosis;
using estimator::Finding;
using estimator::ParameterEstimate;
using estimator::PathErrors;
using estimator::Verdict;

std::string percent(double share) {
  return number(100.0 * share, 0) + " %";
}

std::string joined(const std::vector<std::string>& parts, const std::string& last = " and ") {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) out += i + 1 == parts.size() ? last : ", ";
    out += parts[i];
  }
  return out;
}

std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
  return text;
}

/// The path with the larger gain, for the headline.
const PathErrors* clearest(const Diagnosis& d) {
  const auto gain = [](const std::optional<PathErrors>& p) {
    return p && p->before > 0 ? 1.0 - p->after / p->before : -1.0;
  };
  if (!d.spring && !d.drive) return nullptr;
  return gain(d.spring) >= gain(d.drive) ? &*d.spring : &*d.drive;
}

std::string missing_headline(const Diagnosis& d) {
  std::vector<std::string> names;
  for (const Finding& f : d.findings) names.push_back(title_of(f.effect));
  std::string out = "The simulation leaves something out: " + joined(names) + ".";
  double least = 1.0;
  for (const Finding& f : d.findings) least = std::min(least, f.probability);
  out += " This is " + how_sure(least) + ".";
  const PathErrors* path = clearest(d);
  if (path && path->after < path->before) {
    out += " With it, " + improvement(path->before, path->after) + ".";
  }
  if (d.unexplained) out += " Something more remains that has no name in the catalogue.";
  return out;
}

std::string unexplained_sentence(const estimator::Unexplained& u) {
  std::string out = "Unexplained";
  if (!u.what.empty()) out += ": " + u.what;
  if (const std::string place = where(u.located); !place.empty()) out += "; at " + place;
  return out + ".";
}

std::string parameter_text(const ParameterEstimate& p) {
  const Quantity q = quantity_of(p.name);
  return q.name + " = " + with_unit(p.value, q.unit) + " (95 %: " + figures(p.lower) + " to " +
         figures(p.upper) + ")";
}

void describe(const Finding& f, std::vector<std::string>& out) {
  out.push_back(f.effect + ": " + title_of(f.effect) + ", " + how_sure(f.probability) + "; " +
                improvement(f.before_nm, f.after_nm) + ".");
  std::vector<std::string> numbers;
  for (const auto& p : f.parameters) numbers.push_back(parameter_text(p));
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

std::string title_of(const std::string& effect) {
  const auto* known = estimator::find_effect(effect);
  return known ? known->about().title : effect;
}

std::string how_sure(double p) {
  const char* words = p >= 0.95  ? "almost certain"
                      : p >= 0.8 ? "very likely"
                      : p >= 0.6 ? "likely"
                                 : "possible";
  // Nothing measured is certain: 99.6 % is not written as 100 %.
  return std::string(words) + " (" + (p > 0.99 ? "over 99 %" : percent(p)) + ")";
}

std::string where(const estimator::Located& located) {
  if (located.regions.empty()) return "";
  std::vector<std::string> ranges;
  const Quantity q = quantity_of(located.regions.front().channel);
  for (const auto& r : located.regions) {
    if (r.channel == located.regions.front().channel) {
      ranges.push_back(figures(r.from, 2) + " to " + figures(r.to, 2));
    }
  }
  if (ranges.size() > 3) {
    ranges.resize(2);
    ranges.push_back("elsewhere");
  }
  return q.name + " " + joined(ranges) + (q.unit.empty() ? "" : " " + q.unit);
}

std::string improvement(double before_nm, double after_nm) {
  return "the error on data that no fit has seen falls from " + figures(before_nm, 2) + " to " +
         with_unit(after_nm, "N·m", 2);
}

std::string headline(const Diagnosis& d) {
  switch (d.verdict) {
    case Verdict::consistent:
      return "Nothing is missing: the simulation says what was measured, within the noise.";
    case Verdict::recalibrate:
      return "No physics is missing, but numbers of the model are off. Refitted, it says what was "
             "measured, within the noise.";
    case Verdict::missing_physics:
      return missing_headline(d);
    case Verdict::unexplained:
      return "The simulation leaves something out that no effect of the catalogue explains.";
  }
  return "";
}

std::vector<std::string> moved_numbers(const Diagnosis& d,
                                       const std::optional<estimator::Model>& given) {
  std::vector<std::string> out;
  for (const auto& p : d.numbers) {
    const auto was = given ? given->get(p.effect, p.name) : std::nullopt;
    if (!was || (*was >= p.lower && *was <= p.upper)) continue;
    const Quantity q = quantity_of(p.name);
    out.push_back(p.effect + " " + q.name + ": " + figures(*was) + " in the model, " +
                  with_unit(p.value, q.unit) + " measured (95 %: " + figures(p.lower) + " to " +
                  figures(p.upper) + ")");
  }
  return out;
}

std::vector<std::string> sentences(const Diagnosis& d,
                                   const std::optional<estimator::Model>& given) {
  std::vector<std::string> out{headline(d)};
  for (const Finding& f : d.findings) describe(f, out);
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
  for (const auto& moved : moved_numbers(d, given)) out.push_back("Number off: " + moved + ".");
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
