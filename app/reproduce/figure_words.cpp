#include "app/reproduce/figure_words.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "app/report/axis.h"

namespace searig::app::reproduce {
namespace {

std::string percent(double value, int decimals = 0) {
  return number(value, decimals) + " %";
}

std::string mean_percent(const std::vector<double>& values) {
  const Spread spread = spread_of(values);
  return percent(spread.mean, 1) + " (" + number(spread.least, 1) + " to " +
         number(spread.most, 1) + ")";
}

double share_percent(const std::vector<double>& values, auto&& holds) {
  return 100.0 * static_cast<double>(std::ranges::count_if(values, holds)) /
         static_cast<double>(values.size());
}

double largest(const std::vector<double>& values) {
  double out = 0.0;
  for (const double value : values) out = std::max(out, std::abs(value));
  return out;
}

double mean_of(const std::vector<TrialFigures>& trials, double TrialFigures::*what) {
  double sum = 0.0;
  for (const auto& trial : trials) sum += trial.*what;
  return sum / static_cast<double>(trials.size());
}

struct Words {
  std::string paper, ours, verdict;
};

Words table_words(const Reproduction& all) {
  const auto rows = table_1(all, all.trials);
  const Targets t = targets(all.trials, 0);
  const auto mean = [&](const char* key) {
    const auto row = std::ranges::find(rows, key, &Row::key);
    return mean_percent(row->trials);
  };
  const bool good = t.over_best_fit <= most_over_best_fit && t.over_current <= most_over_current;
  return {
      "Best fit 7 %, online 8 %, motor current 21 %: online is 1.14 times the best fit and 0.38 "
      "times the current.",
      "Best fit " + mean("best_fit") + ", online " + mean("online_paper") + ", motor current " +
          mean("current") + ": online is " + number(t.over_best_fit, 2) +
          " times the best fit and " + number(t.over_current, 2) +
          " times the current. Mean over the trials, in brackets "
          "the least and the most.",
      std::string(good ? "Agrees: " : "Differs: ") +
          "whether the online estimate is as good as the best fit and far better than the "
          "current is what the table is about. The level of the errors is set by the rubber's "
          "loss and the train's friction, of which the paper prints neither; they were chosen "
          "and not fitted to the table."};
}

Words mullins_words(const Reproduction& all) {
  const auto& k = all.cycles.stiffness_nm_per_rad;
  const double change = 100.0 * (1.0 - k.back() / k.front());
  return {
      "Torque over displacement upon repeated cycling; the spring constant changed by about 25 "
      "%. Neither the strokes nor the stiffness are printed.",
      std::to_string(k.size()) + " strokes of ±" +
          number(figure_3_amplitude_rad * 180 / 3.14159265, 1) + " degrees take the slope from " +
          number(k.front(), 1) + " to " + number(k.back(), 1) + " N·m/rad: " + percent(change, 1) +
          " less.",
      std::string(change > 15 && change < 35 ? "Agrees, as it must: " : "Differs: ") +
          "the 25 % were put in; the first stroke already softens and the last has a little "
          "left. The loops are open because the rubber loses work, which a linear model cannot "
          "say."};
}

Words current_words(const Reproduction& all, const Window& good) {
  const double trusted = mean_of(all.trials, &TrialFigures::current_trusted_percent);
  const double rest = mean_of(all.trials, &TrialFigures::current_rest_percent);
  return {
      "The current's torque against the measured one. Sections IV-C and V-A: stiction, backlash "
      "at reversals and inertia spoil it; it is accurate while the deflection grows.",
      "Error in this window " + percent(error_percent(good, good.current_error_nm, 0), 0) +
          ". Over all trials " + percent(trusted, 1) +
          " of the mean torque where the weight is "
          "above one half, " +
          percent(rest, 1) + " elsewhere.",
      std::string(trusted < 0.5 * rest ? "Agrees: " : "Differs: ") +
          "while the spring is being loaded the current follows; when the load goes back, "
          "friction holds it and the current is far too low. The torque scale is ours: the "
          "paper's text gives only its 6 N·m."};
}

Words weight_words(const Window& good) {
  const double none = share_percent(good.weight, [](double w) { return w == 0.0; });
  const double full = share_percent(good.weight, [](double w) { return w == 1.0; });
  return {
      "Time 0 to 15 s, weight 0 to 1. Equation (3) with γ = 20; the weight jumps between 0 and "
      "values up to 1, each pull a spike.",
      "0 for " + percent(none) + " of the window, 1 for " + percent(full) + " of it.",
      std::string(full > 0 && none > 20 && none < 90 ? "Agrees" : "Differs") +
          " with γ taken as 20 degrees² per second. The paper prints no unit; in radians the "
          "weight would never leave a few thousandths."};
}

Words online_words(const Window& good) {
  const double error = error_percent(good, good.online_error_nm, 0);
  return {
      "The torque from deflection and estimated stiffness against the measured one; started "
      "from a good stiffness.",
      "Error in this window " + percent(error, 1) + ", started from the best fit.",
      std::string(error < 12 ? "Agrees: " : "Differs: ") +
          "the two curves should nearly cover each other. What is left is the rubber's loss, "
          "largest at the reversals."};
}

Words error_words(const Window& good) {
  const double current = error_percent(good, good.current_error_nm, 0);
  const double online = error_percent(good, good.online_error_nm, 0);
  return {
      "The errors of motor current and spring deflection; the current's is the larger, by Table "
      "I 2.6 times.",
      "Mean error of the current " + number(current / online, 1) +
          " times that of the spring; at most " + number(largest(good.current_error_nm), 1) +
          " and " + number(largest(good.online_error_nm), 1) + " N·m.",
      std::string(current > 2 * online ? "Agrees: " : "Differs: ") +
          "the current's errors come in blocks, one for each time that the load goes back."};
}

Words poor_torque_words(const Window& poor) {
  const double later = error_percent(poor, poor.online_error_nm, 5.0);
  return {
      "As figure 6, with an initial stiffness off by a factor of 10.",
      "The first pull is overestimated, up to " + number(largest(poor.online_nm), 1) +
          " N·m; from 5 s on the error is " + percent(later, 1) + ".",
      std::string(later < 25 ? "Agrees: " : "Differs: ") +
          "after the first pulls the estimate should follow as in figure 6. How fast depends "
          "on the filter's first variance, which the paper does not print: here (10 N·m/rad)²."};
}

Words poor_error_words(const Window& poor) {
  const double current = error_percent(poor, poor.current_error_nm, 5.0);
  const double online = error_percent(poor, poor.online_error_nm, 5.0);
  return {
      "Section VII names it with 9 and 11; the text that we have holds no caption. Drawn by its "
      "place: figure 7 from the poor start.",
      "From 5 s on the current's mean error is " + number(current / online, 1) +
          " times that of the spring.",
      std::string(current > online ? "Agrees with section VII: " : "Differs: ") +
          "within seconds the spring, started ten times off, should beat the current."};
}

Words stiffness_words(const Reproduction& all, const Window& poor) {
  const double k = all.shown.figures.best_fit_k_nm_per_rad;
  const auto within = [&](double share) {
    const double s = settled_s(poor, k, share);
    return std::isfinite(s) ? "from " + number(s, 1) + " s on"
                            : std::string("not for good in 15 s");
  };
  const auto half = std::ranges::find_if(poor.stiffness_nm_per_rad,
                                         [&](double value) { return value < 2.0 * k; });
  const std::size_t i = static_cast<std::size_t>(half - poor.stiffness_nm_per_rad.begin());
  const double double_s = i < poor.t_s.size() ? poor.t_s[i] : NAN;
  const Targets t = targets(all.trials, 0);
  return {
      "The stiffness over time from a poor start: it quickly converges to an accurate value, by "
      "section VII in a matter of seconds.",
      "Below twice the best fit after " + number(double_s, 1) + " s; within 20 % of it " +
          within(0.2) + ", within 10 % " + within(0.1) + ".",
      std::string(double_s < 5 ? "Agrees: " : "Differs: ") +
          "the wrong start should be gone within seconds. Then the estimate goes to and fro: "
          "when the trust weight has summed to 5 s it is within 5 % of the best fit in " +
          std::to_string(t.close) + " of " + std::to_string(t.reached) +
          " trials (see the targets for why)."};
}

Words words_of(const std::string& name, const Reproduction& all, const Window& good,
               const Window& poor) {
  if (name == "table_1") return table_words(all);
  if (name == "figure_03") return mullins_words(all);
  if (name == "figure_04") return current_words(all, good);
  if (name == "figure_05") return weight_words(good);
  if (name == "figure_06") return online_words(good);
  if (name == "figure_07") return error_words(good);
  if (name == "figure_09") return poor_torque_words(poor);
  if (name == "figure_10") return poor_error_words(poor);
  if (name == "figure_11") return stiffness_words(all, poor);
  throw std::logic_error("no words for " + name);
}

}  // namespace

void say(std::vector<Figure>& figures, const Reproduction& all, const Window& good,
         const Window& poor) {
  for (Figure& figure : figures) {
    const Words words = words_of(figure.name, all, good, poor);
    figure.paper = words.paper, figure.ours = words.ours, figure.verdict = words.verdict;
  }
}

}  // namespace searig::app::reproduce
