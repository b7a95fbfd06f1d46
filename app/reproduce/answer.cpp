#include "app/reproduce/answer.h"

#include <cstdio>

#include "app/report/axis.h"

namespace searig::app::reproduce {
namespace {

using nlohmann::json;

json table_json(const Reproduction& all, const std::vector<TrialFigures>& trials) {
  json out = json::object();
  for (const Row& row : table_1(all, trials)) {
    const Spread spread = spread_of(row.trials);
    out[row.key] = {{"error_percent", spread.mean},
                    {"sd", spread.sd},
                    {"least", spread.least},
                    {"most", spread.most}};
    if (row.paper) out[row.key]["paper_percent"] = *row.paper;
  }
  return out;
}

json targets_json(const Targets& t, std::size_t trials) {
  return {{"trials", trials},
          {"online_over_best_fit",
           {{"value", t.over_best_fit},
            {"at_most", most_over_best_fit},
            {"met", t.over_best_fit <= most_over_best_fit},
            {"trials_met", t.within_best_fit}}},
          {"online_over_current",
           {{"value", t.over_current},
            {"at_most", most_over_current},
            {"met", t.over_current <= most_over_current},
            {"trials_met", t.within_current}}},
          {"stiffness_within_5_percent_at_trust_weight_5_s",
           {{"trials_reached", t.reached},
            {"trials_met", t.close},
            {"met", t.close == static_cast<int>(trials)},
            {"median_off_percent", t.median_off_percent},
            {"worst_off_percent", t.worst_off_percent},
            {"mean_off_percent", t.mean_off_percent},
            {"mean_off_percent_with_loadcell", t.loadcell_off_percent},
            {"time_within_later_percent", t.within_later_percent}}}};
}

json trial_json(const TrialFigures& trial, const std::vector<Variant>& variants) {
  json out = {{"seed", trial.seed},
              {"best_fit_k_nm_per_rad", trial.best_fit_k_nm_per_rad},
              {"best_fit_error_percent", trial.best_fit.error_percent},
              {"current_error_percent", trial.current.error_percent}};
  for (std::size_t v = 0; v < variants.size(); ++v) {
    const auto& [good, poor, last_k, approach] = trial.online[v];
    json online = {{"error_percent", good.error_percent},
                   {"error_percent_from_poor_start", poor.error_percent},
                   {"last_k_nm_per_rad", last_k}};
    if (approach) {
      online["trust_weight_5_s_after_s"] = approach->after_s;
      online["off_percent_then"] = approach->off_percent;
      online["time_within_5_percent_later_percent"] = approach->within_later_percent;
    }
    out["online_" + variants[v].key] = online;
  }
  return out;
}

std::string met(bool yes) {
  return yes ? "met" : "MISSED";
}

}  // namespace

json to_json(const Reproduction& all, const std::vector<Figure>& figures) {
  json targets_of = json::object(), trials = json::array(), files = json::array();
  for (std::size_t v = 0; v < all.variants.size(); ++v) {
    targets_of[all.variants[v].key] = targets_json(targets(all.trials, v), all.trials.size());
  }
  for (const auto& trial : all.trials) trials.push_back(trial_json(trial, all.variants));
  for (const auto& figure : figures) {
    files.push_back({{"name", figure.name},
                     {"png", figure.name + ".png"},
                     {"csv", figure.name + ".csv"},
                     {"agrees", figure.agrees},
                     {"verdict", figure.verdict}});
  }
  return {{"format", "searig-reproduction/1"},
          {"seconds_of_a_trial", all.settings.protocol.seconds},
          {"table_1", table_json(all, all.trials)},
          {"targets", targets_of},
          {"hand_drags", {{"table_1", table_json(all, all.dragged)}}},
          {"trials", trials},
          {"figures", files},
          {"report", "reproduction.html"}};
}

std::vector<std::string> target_sentences(const Targets& t, int trials) {
  const std::string all = " of " + std::to_string(trials);
  return {"Online error " + number(t.over_best_fit, 2) + " times the best fit's, at most " +
              number(most_over_best_fit, 1) +
              " asked: " + met(t.over_best_fit <= most_over_best_fit) + " (by itself in " +
              std::to_string(t.within_best_fit) + all + " trials).",
          "Online error " + number(t.over_current, 2) + " times the motor current's, at most " +
              number(most_over_current, 1) + " asked: " + met(t.over_current <= most_over_current) +
              " (" + std::to_string(t.within_current) + all + ").",
          "From ten times too high within 5 % of the best fit when the trust weight has summed to "
          "5 s: " +
              met(t.close == trials) + " (" + std::to_string(t.close) + all + "; off by " +
              number(t.median_off_percent, 1) + " % in the median, " +
              number(t.worst_off_percent, 1) + " % at most)."};
}

std::vector<std::string> describe(const Reproduction& all) {
  std::vector<std::string> lines = {"Table I over " + std::to_string(all.trials.size()) +
                                    " trials of " + number(all.settings.protocol.seconds, 0) +
                                    " s on the twin:"};
  for (const Row& row : table_1(all, all.trials)) {
    const Spread spread = spread_of(row.trials);
    char text[160];
    std::snprintf(text, sizeof text, "  %-43s %5.1f %%  (%.1f to %.1f)%s", row.name.c_str(),
                  spread.mean, spread.least, spread.most,
                  row.paper ? ("   paper " + number(*row.paper, 0) + " %").c_str() : "");
    lines.emplace_back(text);
  }
  for (std::size_t v = 0; v < all.variants.size(); ++v) {
    lines.push_back(all.variants[v].name + ":");
    for (const auto& sentence :
         target_sentences(targets(all.trials, v), static_cast<int>(all.trials.size()))) {
      lines.push_back("  " + sentence);
    }
  }
  return lines;
}

}  // namespace searig::app::reproduce
