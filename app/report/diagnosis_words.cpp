#include "app/report/diagnosis_words.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/report/axis.h"
#include "app/report/quantity.h"
#include "estimator/physics/catalogue.h"

namespace searig::app {
namespace {

using estimator::Diagnosis;
using estimator::Finding;
using estimator::ParameterEstimate;
using estimator::PathErrors;

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

}  // namespace

std::string percent(double share) {
  return number(100.0 * share, 0) + " %";
}

std::string joined(const std::vector<std::string>& parts, const std::string& last,
                   const std::string& between) {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) out += i + 1 == parts.size() ? last : between;
    out += parts[i];
  }
  return out;
}

const PathErrors* first_of(const Diagnosis& d) {
  return d.spring ? &*d.spring : d.drive ? &*d.drive : nullptr;
}

const PathErrors* clearest(const Diagnosis& d) {
  const auto gain = [](const std::optional<PathErrors>& p) {
    return p->before > 0 ? 1.0 - p->after / p->before : -INFINITY;
  };
  if (!d.spring || !d.drive) return first_of(d);
  return gain(d.spring) >= gain(d.drive) ? &*d.spring : &*d.drive;
}

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
  std::vector<std::string> effects;  // in the order in which they came
  for (const ParameterEstimate& p : parameters)
    if (std::ranges::find(effects, p.effect) == effects.end()) effects.push_back(p.effect);
  const auto place = [&](const ParameterEstimate& p) {
    const auto came = std::ranges::find(effects, p.effect) - effects.begin();
    const auto* effect = estimator::find_effect(p.effect);
    if (!effect) return std::pair(came, std::ptrdiff_t(0));
    const auto& known = effect->parameters();
    return std::pair(came,
                     std::ranges::find(known, p.name, &estimator::Parameter::name) - known.begin());
  };
  std::ranges::stable_sort(parameters, {}, place);
  return parameters;
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
