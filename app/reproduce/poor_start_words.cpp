#include <algorithm>
#include <cmath>
#include <limits>

#include "app/reproduce/words.h"

namespace searig::app::reproduce {
namespace {

constexpr double seconds_later = 5.0;  // "in a matter of seconds", section VII

/// "from 7.7 s on"
std::string settled(const Window& poor, double k, double share) {
  const double s = settled_s(poor, k, share);
  return std::isfinite(s) ? "from " + number(s, 1) + " s on" : "not for good in this window";
}

double first_below_s(const Window& poor, double k) {
  const auto below =
      std::ranges::find_if(poor.stiffness_nm_per_rad, [k](double value) { return value < k; });
  const auto i = static_cast<std::size_t>(below - poor.stiffness_nm_per_rad.begin());
  return i < poor.t_s.size() ? poor.t_s[i] : std::numeric_limits<double>::infinity();
}

}  // namespace

Words poor_torque_words(const Window& poor) {
  const double later = error_percent(poor, poor.online_error_nm, seconds_later);
  double highest = 0.0;
  for (const double error : poor.online_error_nm) highest = std::max(highest, std::abs(error));
  return {"As figure 6, with an initial stiffness off by a factor of 10.",
          "At first up to " + number(highest, 1) + " N·m off; from 5 s on the error is " +
              percent(later, 1) + ".",
          later < 25,
          "after the first pulls the estimate follows.",
          "after the first pulls the estimate is still far off.",
          "How fast depends on the filter's first variance, which the paper does not print: here "
          "(10 N·m/rad)²."};
}

Words poor_error_words(const Window& poor) {
  const double current = error_percent(poor, poor.current_error_nm, seconds_later);
  const double online = error_percent(poor, poor.online_error_nm, seconds_later);
  return {
      "Section VII names it with 9 and 11; the text that we have holds no caption. Drawn by its "
      "place: figure 7 from the poor start.",
      "From 5 s on the current's mean error is " + number(current / online, 1) +
          " times that of the spring.",
      current > online,
      "within seconds the spring, started ten times off, beats the current.",
      "the spring, started ten times off, does not beat the current within seconds.",
      ""};
}

Words stiffness_words(const Reproduction& all, const Window& poor) {
  const double k = all.shown.figures.best_fit_k_nm_per_rad;
  const double near_s = first_below_s(poor, 2.0 * k);
  const Targets t = targets(all.trials, 0);
  return {
      "The stiffness over time from a poor start: it quickly converges to an accurate value, by "
      "section VII in a matter of seconds.",
      "Below twice the best fit after " + number(near_s, 1) + " s; within 20 % of it " +
          settled(poor, k, 0.2) + ", within 10 % " + settled(poor, k, 0.1) + ".",
      near_s < seconds_later,
      "the wrong start is gone within seconds.",
      "the wrong start is not gone within seconds.",
      "Then the estimate goes to and fro: when the trust weight has summed to 5 s it is within "
      "5 % of the best fit in " +
          std::to_string(t.close) + " of " + std::to_string(t.reached) +
          " trials (why: see what was asked for)."};
}

}  // namespace searig::app::reproduce
