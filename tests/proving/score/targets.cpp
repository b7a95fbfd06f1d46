#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "tests/proving/score/table.h"

namespace searig::proving {
namespace {

using nlohmann::json;
using Test = std::function<bool(const Judgement&)>;

struct Share {
  int hits = 0, of = 0;
  double value() const { return of > 0 ? static_cast<double>(hits) / of : std::nan(""); }
};

Share share(const Judgements& all, const Test& among, const Test& hit) {
  Share s;
  for (const auto& [name, j] : all)
    if (among(j)) ++s.of, s.hits += hit(j);
  return s;
}

Test stratum(const std::vector<std::string>& names) {
  return [names](const Judgement& j) {
    return std::find(names.begin(), names.end(), j.stratum) != names.end();
  };
}

double f1(const Judgements& all, const std::string& name) {
  double tp = 0, wrong = 0;
  for (const auto& [recording, j] : all)
    if (j.stratum == name) tp += j.true_positives, wrong += j.false_positives + j.false_negatives;
  return tp + wrong > 0 ? 2.0 * tp / (2.0 * tp + wrong) : std::nan("");
}

/// One target: the figure, its limit, and on which side of it is good.
struct Lines {
  std::ostream& out;
  json machine = json::array();

  void add(const std::string& what, double value, double low, double high, int n,
           const char* target) {
    const bool known = !std::isnan(value), met = known && value >= low && value <= high;
    char line[160];
    if (known)
      std::snprintf(line, sizeof line, "%s %-46s %8.3f  target %-12s n %d\n", met ? "ok" : "--",
                    what.c_str(), value, target, n);
    else
      std::snprintf(line, sizeof line, "   %-46s %8s  target %-12s n 0\n", what.c_str(), "-",
                    target);
    out << line;
    machine.push_back({{"what", what},
                       {"measured", known ? json(value) : json()},
                       {"target", target},
                       {"met", met},
                       {"n", n}});
  }
  void add(const std::string& what, Share s, double low, double high, const char* target) {
    add(what, s.value(), low, high, s.of, target);
  }
};

std::vector<double> collect(
    const Judgements& all,
    const std::function<void(const Judgement&, std::vector<double>&)>& take) {
  std::vector<double> values;
  for (const auto& [name, j] : all) take(j, values);
  return values;
}

}  // namespace

json print_targets(const Judgements& all, std::ostream& out) {
  Lines lines{out};
  const Test named = [](const Judgement& j) { return j.named; };
  const Test anything = [](const Judgement&) { return true; };
  const Test nameless = stratum({"nameless"});
  const Test real = [&](const Judgement& j) { return !j.stratum.starts_with("null"); };
  const Test wrong = [](const Judgement& j) {
    return j.stratum == "nameless" ? j.misnamed : j.wrong;
  };
  const Test alarm = [](const Judgement& j) { return j.alarm; };

  lines.add("named, strong and medium",
            share(all, stratum({"single strong", "single medium"}), named), 0.95, 1, ">= 0.95");
  lines.add("named, weak", share(all, stratum({"single weak"}), named), 0.70, 1, ">= 0.70");
  lines.add("named, masked", share(all, stratum({"masked"}), named), 0, 1, "reported");
  lines.add("mentioned under poor excitation",
            share(all, stratum({"poor"}), [](const Judgement& j) { return j.contains; }), 0.95, 1,
            ">= 0.95");
  lines.add("confidently wrong", share(all, real, wrong), 0, 0.02, "<= 0.02");
  lines.add("any confident name for the nameless",
            share(all, nameless, [](const Judgement& j) { return j.wrong; }), 0, 1, "reported");
  lines.add("false alarms, exact numbers", share(all, stratum({"null exact"}), alarm), 0, 0.0, "0");
  lines.add("false alarms, wrong numbers", share(all, stratum({"null numbers"}), alarm), 0,
            1.0 / 60, "<= 1 in 60");
  lines.add("F1 of pairs", f1(all, "pair"), 0.95, 1, share(all, stratum({"pair"}), anything).of,
            ">= 0.95");
  lines.add("F1 of triples", f1(all, "triple"), 0.90, 1,
            share(all, stratum({"triple"}), anything).of, ">= 0.90");
  lines.add("nameless flagged",
            share(all, nameless, [](const Judgement& j) { return j.unexplained; }), 0.90, 1,
            ">= 0.90");

  const auto overlaps = collect(all, [](const Judgement& j, auto& v) {
    if (j.local) v.push_back(j.overlap.value_or(0.0));
  });
  lines.add("located: median overlap", median(overlaps), 0.7, 1, static_cast<int>(overlaps.size()),
            ">= 0.7");
  const auto errors = collect(all, [](const Judgement& j, auto& v) {
    for (const auto& p : j.parameters) v.push_back(p.relative_error);
  });
  lines.add("parameter error: median, relative", median(errors), 0, 0.05,
            static_cast<int>(errors.size()), "<= 0.05");
  const auto covered = collect(all, [](const Judgement& j, auto& v) {
    for (const auto& p : j.parameters)
      if (p.covered) v.push_back(*p.covered);
  });
  double inside = 0.0;
  for (const double c : covered) inside += c;
  lines.add("95 % intervals that cover",
            covered.empty() ? std::nan("") : inside / static_cast<double>(covered.size()), 0.90,
            0.98, static_cast<int>(covered.size()), "0.90-0.98");
  const auto ratios = collect(all, [](const Judgement& j, auto& v) {
    v.insert(v.end(), j.heldout_over_reachable.begin(), j.heldout_over_reachable.end());
  });
  lines.add("held-out over reachable: median", median(ratios), 0, 1.1,
            static_cast<int>(ratios.size()), "<= 1.1");
  const auto seconds = collect(all, [](const Judgement& j, auto& v) { v.push_back(j.seconds); });
  lines.add("seconds per recording: median", median(seconds), 0, 10,
            static_cast<int>(seconds.size()), "<= 10");
  lines.add("failed", share(all, anything, [](const Judgement& j) { return j.failed; }), 0, 0, "0");
  return lines.machine;
}

json print_reliability(const Judgements& all, std::ostream& out) {
  static const std::vector<double> edges{0.0, 0.5, 0.7, 0.8, 0.9, 0.95, 0.99, 1.0001};
  std::vector<Asserted> everything;
  for (const auto& [name, j] : all)
    everything.insert(everything.end(), j.asserted.begin(), j.asserted.end());
  json bins = json::array();
  double brier = 0.0, ece = 0.0;
  const double total = std::max<double>(1.0, static_cast<double>(everything.size()));
  for (const auto& a : everything) brier += std::pow(a.probability - a.true_one, 2) / total;
  out << "reliability: stated probability, findings, share that is true\n";
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    double n = 0, stated = 0, observed = 0;
    for (const auto& a : everything)
      if (a.probability >= edges[b] && a.probability < edges[b + 1])
        n += 1, stated += a.probability, observed += a.true_one;
    if (n == 0) continue;
    ece += std::abs(stated - observed) / total;
    char line[160];
    std::snprintf(
        line, sizeof line, "  %.2f-%.2f  stated %.3f  n %4.0f  true %.3f  |%s\n", edges[b],
        std::min(1.0, edges[b + 1]), stated / n, n, observed / n,
        std::string(static_cast<std::size_t>(std::lround(40 * observed / n)), '#').c_str());
    out << line;
    bins.push_back(
        {{"from", edges[b]}, {"n", n}, {"stated", stated / n}, {"observed", observed / n}});
  }
  char line[80];
  std::snprintf(line, sizeof line, "  Brier %.4f  ECE %.4f\n", brier, ece);
  out << line;
  return {{"bins", bins}, {"brier", brier}, {"ece", ece}};
}

}  // namespace searig::proving
