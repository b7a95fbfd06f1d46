#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/reproduce/words.h"

namespace searig::app::reproduce {
namespace {

std::string mean_percent(const std::vector<Row>& rows, const char* key) {
  const Spread spread = spread_of(std::ranges::find(rows, key, &Row::key)->trials);
  return percent(spread.mean, 1) + " (" + number(spread.least, 1) + " to " +
         number(spread.most, 1) + ")";
}

/// "1.8, 0.5 and 5.5 points above the paper's"
std::string points_above(const std::vector<Row>& rows) {
  std::string words;
  for (const Row& row : rows) {
    if (!row.paper) continue;
    if (!words.empty()) words += row.key == "current" ? " and " : ", ";
    words += number(spread_of(row.trials).mean - *row.paper, 1);
  }
  return words + " points above the paper's";
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

}  // namespace

Words table_words(const Reproduction& all) {
  const auto rows = table_1(all, all.trials);
  const Targets t = targets(all.trials, 0);
  return {
      "Best fit 7 %, online 8 %, motor current 21 %: online is 1.14 times the best fit and 0.38 "
      "times the current.",
      "Best fit " + mean_percent(rows, "best_fit") + ", online " +
          mean_percent(rows, "online_paper") + ", motor current " + mean_percent(rows, "current") +
          ": online is " + number(t.over_best_fit, 2) + " times the best fit and " +
          number(t.over_current, 2) +
          " times the current. Means over the trials, in brackets the least and the most.",
      t.over_best_fit <= most_over_best_fit && t.over_current <= most_over_current,
      "the online estimate is as good as the best fit and far better than the current.",
      "the online estimate is not what the paper's is beside best fit and current.",
      "Their level is " + points_above(rows) +
          ". It comes from the rubber's loss and the train's friction; the paper prints neither. "
          "They were chosen and not fitted to the table."};
}

Words mullins_words(const Reproduction& all) {
  const auto& k = all.cycles.stiffness_nm_per_rad;
  const double change = 100.0 * (1.0 - k.back() / k.front());
  return {
      "A graphical example of the softening after repeated loading; the spring constant changed "
      "by about 25 %. The text that we have tells neither axes, strokes nor stiffness.",
      std::to_string(k.size()) + " strokes of ±" +
          number(figure_3_amplitude_rad * 180.0 / std::numbers::pi, 1) +
          " degrees take the slope from " + number(k.front(), 1) + " to " + number(k.back(), 1) +
          " N·m/rad: " + percent(change, 1) + " less.",
      change > 15 && change < 35,
      "as it must, for the 25 % were put in.",
      "although 25 % were put in.",
      "The first stroke already softens, and the last has a little left. The loops are open "
      "because the rubber loses work, which a linear model cannot say."};
}

Words current_words(const Reproduction& all, const Window& good) {
  const double trusted = mean_of(all.trials, &TrialFigures::current_trusted_percent);
  const double rest = mean_of(all.trials, &TrialFigures::current_rest_percent);
  return {
      "The current's torque against the measured one. Sections IV-C and V-A: stiction, backlash "
      "at reversals and inertia spoil it; it is accurate while the deflection grows.",
      "Error in this window " + percent(error_percent(good, good.current_error_nm, 0)) +
          ". Over all trials " + percent(trusted, 1) +
          " of the mean torque where the weight is above one half, " + percent(rest, 1) +
          " elsewhere.",
      trusted < 0.5 * rest,
      "while the spring is being loaded the current follows; when the load goes back, friction "
      "holds it and the current is far too low.",
      "the current is not much better where it is trusted.",
      "The torque scale is ours: the paper's text gives only its 6 N·m."};
}

Words weight_words(const Window& good) {
  const double none = 100.0 * static_cast<double>(std::ranges::count(good.weight, 0.0)) /
                      static_cast<double>(good.weight.size());
  const double most = largest(good.weight);
  return {
      "Time 0 to 15 s, weight 0 to 1. Equation (3) with γ = 20: negative weights are discarded, "
      "large ones end at 1.",
      "0 for " + percent(none) + " of the window, at most " + number(most, 2) +
          "; a hump for each time that the spring is loaded.",
      most > 0.5 && none > 20 && none < 90,
      "with γ taken as 20 degrees² per second the weight covers its axis.",
      "with γ taken as 20 degrees² per second the weight does not cover its axis.",
      "The paper prints no unit; in radians the weight would never leave a few thousandths. "
      "What looks like fur is the encoders' noise in the rate."};
}

Words online_words(const Window& good) {
  const double error = error_percent(good, good.online_error_nm, 0);
  return {
      "The torque from deflection and estimated stiffness against the measured one; started "
      "from a good stiffness.",
      "Error in this window " + percent(error, 1) + ", started from the best fit.",
      error < 12,
      "the two curves nearly cover each other.",
      "the two curves do not cover each other.",
      "What is left is mostly the rubber's loss: it pushes harder on the way in than on the way "
      "out."};
}

Words error_words(const Window& good) {
  const double current = error_percent(good, good.current_error_nm, 0);
  const double online = error_percent(good, good.online_error_nm, 0);
  return {
      "The errors of motor current and spring deflection; by Table I the current's is 2.6 times "
      "as large.",
      "Mean error of the current " + number(current / online, 1) +
          " times that of the spring; at most " + number(largest(good.current_error_nm), 1) +
          " and " + number(largest(good.online_error_nm), 1) + " N·m.",
      current > 2 * online,
      "the current's errors are far larger.",
      "the current's errors are not far larger.",
      "They come in blocks, one for each time that the load goes back."};
}

}  // namespace searig::app::reproduce
