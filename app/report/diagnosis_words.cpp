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

std::string joined(const std::vector<std::string>& parts, const std::string& last = " and ",
                   const std::string& between = ", ") {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) out += i + 1 == parts.size() ? last : between;
    out += parts[i];
  }
  return out;
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
  std::string out = "The simulation leaves something out: ";
  if (d.findings.size() == 1) {
    const Finding& f = d.findings.front();
    out += title_of(f.effect) + ". This is " + how_sure(f.probability) + ".";
  } else {
    std::vector<std::string> names;
    for (const Finding& f : d.findings) {
      names.push_back(title_of(f.effect) + ", " + how_sure(f.probability));
    }
    out += joined(names, "; and ", "; ") + ".";
  }
  const PathErrors* path = clearest(d);
  if (path && path->after < path->before) {
    out += (d.findings.size() == 1 ? " With it, " : " With them, ") +
           improvement(path->before, path->after) + ".";
  }
  if (d.unexplained) out += " Something more remains that has no name in the catalogue.";
  return out;
}

std::string consistent_headline(const Diagnosis& d) {
  const PathErrors* path = d.spring ? &*d.spring : d.drive ? &*d.drive : nullptr;
  std::string out = "Nothing is missing, and the numbers of the model hold";
  if (!path) return out + ".";
  out += ": what is left, " + with_unit(path->after, "N·m", 2) + ", is noise.";
  if (path->as_given && *path->as_given > 1.3 * path->before) {
    out += " As it came it was off by " + with_unit(*path->as_given, "N·m", 2) +
           ": the sensors' zeros and clocks had to be fitted.";
  }
  return out;
}

std::string recalibrate_headline(const Diagnosis& d) {
  const PathErrors* path = d.spring ? &*d.spring : d.drive ? &*d.drive : nullptr;
  std::string out = "No physics is missing, but numbers of the model are off.";
  if (path && path->as_given && *path->as_given > path->before) {
    out += " With the right ones the error falls from " + figures(*path->as_given, 2) + " to " +
           with_unit(path->after, "N·m", 2) + ", which is noise.";
  }
  return out;
}

std::string unexplained_headline(const Diagnosis& d) {
  std::string out =
      "The simulation leaves something out, and nothing in the catalogue explains it best.";
  if (!d.unexplained) return out;
  if (const std::string place = where(d.unexplained->located); !place.empty()) {
    out += " It shows at " + place + ".";
  }
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

/// Neighbouring ranges that leave hardly a gap are one for a reader.
std::vector<estimator::Region> merged(const estimator::Located& located) {
  std::vector<estimator::Region> out;
  double low = INFINITY, high = -INFINITY;
  for (const auto& r : located.regions) {
    if (r.channel != located.regions.front().channel) continue;
    low = std::min(low, r.from), high = std::max(high, r.to);
    out.push_back(r);
  }
  const double gap = 0.12 * (high - low);
  for (std::size_t i = 1; i < out.size();) {
    if (out[i].from - out[i - 1].to <= gap) {
      out[i - 1].to = out[i].to;
      out.erase(out.begin() + std::ptrdiff_t(i));
    } else {
      ++i;
    }
  }
  return out;
}

std::string where(const estimator::Located& located) {
  if (located.regions.empty()) return "";
  const Quantity q = quantity_of(located.regions.front().channel);
  std::vector<std::string> ranges;
  for (const auto& r : merged(located)) {
    const double size = std::max(std::abs(r.from), std::abs(r.to));
    const auto text = [size](double x) { return std::abs(x) < 0.005 * size ? "0" : figures(x, 2); };
    ranges.push_back(text(r.from) + " to " + text(r.to));
  }
  const std::string unit = q.unit.empty() ? "" : " " + q.unit;
  if (ranges.size() > 3) return q.name + " " + ranges[0] + ", " + ranges[1] + unit + " and more";
  return q.name + " " + joined(ranges) + unit;
}

std::string improvement(double before_nm, double after_nm) {
  return "the error on data that no fit has seen falls from " + figures(before_nm, 2) + " to " +
         with_unit(after_nm, "N·m", 2);
}

std::string improvement(const Diagnosis& d, const Finding& f) {
  const PathErrors* path = clearest(d);
  if (path && d.findings.size() == 1 && f.after_nm > 0.9 * f.before_nm &&
      path->after < 0.9 * path->before) {
    return improvement(path->before, path->after);
  }
  return improvement(f.before_nm, f.after_nm);
}

bool is_measured(const ParameterEstimate& p) {
  return p.upper - p.lower > 1e-7 * std::abs(p.value);
}

std::vector<ParameterEstimate> in_order(std::vector<ParameterEstimate> parameters) {
  const auto place = [](const ParameterEstimate& p) {
    const auto* effect = estimator::find_effect(p.effect);
    if (!effect) return std::ptrdiff_t(0);
    const auto& known = effect->parameters();
    return std::ranges::find(known, p.name, &estimator::Parameter::name) - known.begin();
  };
  std::ranges::stable_sort(parameters, [&](const auto& a, const auto& b) {
    return a.effect == b.effect && place(a) < place(b);
  });
  return parameters;
}

std::string headline(const Diagnosis& d) {
  switch (d.verdict) {
    case Verdict::consistent:
      return consistent_headline(d);
    case Verdict::recalibrate:
      return recalibrate_headline(d);
    case Verdict::missing_physics:
      return missing_headline(d);
    case Verdict::unexplained:
      return unexplained_headline(d);
  }
  return "";
}

std::vector<std::string> moved_numbers(const Diagnosis& d,
                                       const std::optional<estimator::Model>& given) {
  std::vector<std::string> out;
  if (d.verdict == Verdict::consistent) return out;
  for (const auto& p : d.numbers) {
    const auto was = given ? given->get(p.effect, p.name) : std::nullopt;
    if (!was || !is_measured(p) || (*was >= p.lower && *was <= p.upper)) continue;
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

std::string waves_per_turn(const Finding& finding, double gear_ratio) {
  std::vector<std::string> waves;
  for (const ParameterEstimate& p : in_order(finding.parameters))
    if (p.effect == "drive.ripple" && p.name.starts_with("cycles"))
      waves.push_back(figures(p.value / gear_ratio, 3));
  if (waves.empty() || gear_ratio == 1.0) return "";
  return "There are " + joined(waves) +
         " waves to each turn of the motor; what repeats that often makes them: magnet poles, "
         "windings, slots, gear teeth.";
}

}  // namespace searig::app
