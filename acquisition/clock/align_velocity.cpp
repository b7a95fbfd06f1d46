#include "acquisition/clock/align_velocity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "acquisition/clock/device_clock.h"
#include "acquisition/clock/doubt.h"
#include "acquisition/clock/velocity_likeness.h"

namespace searig::acquisition {
namespace {

constexpr double kRateSd = 1e-4;              // of two quartz clocks against each other
constexpr double kMost = 4000, kFewest = 50;  // bins over the reference
constexpr double kChance = 25.0;  // likelihood ratio (as chi^2) that chance does not reach
constexpr double kAsGood = 0.7;   // of the best place's likeness; elsewhere it is a rival
constexpr double kPeak = 0.5;     // what is better than that around the best place belongs to it
constexpr double kInside = 8.0;   // rise of chi^2 at the edge: twice that of 95 % for a smooth
                                  // motion, since that of an edge falls and rises in steps

/// The widths of bins worth trying. Wide ones let the noise of an angle's derivative average out,
/// narrow ones keep quick motions; both velocities are averaged alike.
std::vector<double> widths(std::span<const double> t) {
  const double span = t.back() - t.front();
  std::vector<double> out;
  for (double width = std::max(median_step(t), span / kMost); width <= span / kFewest; width *= 2)
    out.push_back(width);
  if (out.empty()) out.push_back(span / kFewest);
  return out;
}

/// All for one width of the bins.
class Aligner {
 public:
  Aligner(Binned reference, std::span<const double> device_s, std::span<const double> angle)
      : reference_(std::move(reference)),
        device_s_(device_s),
        angle_(angle),
        length_s_(device_s.back() - device_s.front()) {
    try_every_shift();
  }

  /// How much likelier the best place is than no likeness at all, as chi^2.
  double seen() const { return seen_; }

  Alignment run() {
    polish();
    return alignment();
  }

 private:
  Likeness at(const Laid& laid) const {
    return likeness(reference_.velocity, derivative(reference_, device_s_, angle_, laid));
  }

  std::vector<double> residual(const Laid& laid) const {
    const auto x = derivative(reference_, device_s_, angle_, laid);
    return left_over(reference_.velocity, x, likeness(reference_.velocity, x));
  }

  /// Whole shifts of one bin; the device's log must overlap the reference by a quarter of either.
  void try_every_shift() {
    const double d = reference_.width_s, span = d * double(reference_.velocity.size());
    const double overlap = 0.25 * std::min(span, length_s_);
    for (double first = reference_.start_s - length_s_ + overlap;
         first < reference_.start_s + span - overlap; first += d) {
      const Likeness here = at({first, first + length_s_});
      tried_.push_back({first, here.sse});
      if (tried_.size() > 1 && here.sse >= best_.sse) continue;
      best_ = here;
      laid_ = {first, first + length_s_};
    }
    const double n = double(reference_.velocity.size());
    variance_ = std::max(best_.sse / n * correlated(residual(laid_)), 1e-300);
    const std::vector<double> still(reference_.velocity.size(), 0.0);
    seen_ = (likeness(reference_.velocity, still).sse - best_.sse) / variance_;
    look_for_rivals();
  }

  /// Places away from the best one where the velocities are as much alike.
  void look_for_rivals() {
    std::size_t best = 0;
    for (std::size_t i = 1; i < tried_.size(); ++i)
      if (tried_[i].sse < tried_[best].sse) best = i;
    const double all = seen_ * variance_ + tried_[best].sse;
    const auto alike = [&](std::size_t i) { return (all - tried_[i].sse) / (seen_ * variance_); };
    std::size_t from = best, to = best;
    while (from > 0 && alike(from - 1) > kPeak) --from;
    while (to + 1 < tried_.size() && alike(to + 1) > kPeak) ++to;
    for (std::size_t i = 0; i < tried_.size(); ++i)
      if ((i < from || i > to) && alike(i) > kAsGood)
        rival_s_ = tried_[i].first_s - tried_[best].first_s;
  }

  /// What is minimised: misfit, in units of its noise, and the rates' disagreement.
  double cost(const Laid& laid) const {
    const double stretch = (laid.last_s - laid.first_s) / length_s_ - 1.0;
    return at(laid).sse / variance_ + std::pow(stretch / kRateSd, 2);
  }

  /// Both ends are moved, together and apart, in ever smaller steps.
  void polish() {
    constexpr std::array<std::array<double, 2>, 6> ways{
        {{1, 1}, {-1, -1}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    double lowest = cost(laid_);
    for (double step = reference_.width_s; step > 1e-4 * reference_.width_s;) {
      bool moved = false;
      for (const auto& [first, last] : ways) {
        const Laid next{laid_.first_s + first * step, laid_.last_s + last * step};
        const double here = cost(next);
        if (here >= lowest) continue;
        lowest = here, laid_ = next, moved = true;
      }
      if (!moved) step *= 0.5;
    }
    best_ = at(laid_);
  }

  /// How far the log may be shifted, at the best stretch for each shift, before the fit is worse
  /// than chance explains. The likelihood is followed itself, not its curvature: an end of a motion
  /// is an edge, and edges have none.
  double profile_half_width() const {
    const auto worse = [&](double shift_s) {
      double least = HUGE_VAL;
      for (const double sd : {-1.5, -0.75, 0.0, 0.75, 1.5}) {
        const double half = 0.5 * sd * kRateSd * length_s_;
        least =
            std::min(least, cost({laid_.first_s + shift_s - half, laid_.last_s + shift_s + half}));
      }
      return least - cost(laid_);
    };
    double widest = 0.0;
    const double step = 0.1 * reference_.width_s;
    for (const double side : {-1.0, 1.0})
      for (double by = step; by < widest + reference_.width_s && by < length_s_; by += step)
        if (worse(side * by) < kInside) widest = std::max(widest, by);
    return widest + step;
  }

  Alignment alignment() const {
    Alignment out;
    out.rate = (laid_.last_s - laid_.first_s) / length_s_;
    out.offset_s = laid_.first_s - out.rate * device_s_.front();
    // Where within its last interval a device began or ceased to move its log does not say.
    out.ci95_s = std::hypot(profile_half_width(), median_step(device_s_));
    out.correlation = best_.correlation;
    out.trusted = false;
    if (!(best_.correlation > 0) || seen_ < kChance)
      out.why = "the velocities are no more alike anywhere than chance makes them.";
    else if (rival_s_ != 0.0)
      out.why = printed("the velocities are as much alike %.2f s away.", std::abs(rival_s_));
    else if (!(out.ci95_s < 0.1 * length_s_))
      out.why = "the motion does not say when it happened.";
    else {
      out.trusted = true;
      out.why = printed(
          "the derivative of its angle follows the module's velocity (correlation %.2f, far "
          "beyond chance); before and after its log it is taken to stand still.",
          best_.correlation);
    }
    return out;
  }

  Binned reference_;
  std::span<const double> device_s_, angle_;
  double length_s_;
  struct Tried {
    double first_s, sse;
  };
  std::vector<Tried> tried_;
  Laid laid_{};
  Likeness best_;
  double seen_ = 0.0, variance_ = 1.0;
  double rival_s_ = 0.0;  ///< how far away the velocities are as much alike, or 0
};

}  // namespace

Alignment align_by_velocity(std::span<const double> reference_s, std::span<const double> velocity,
                            std::span<const double> device_s, std::span<const double> angle) {
  if (reference_s.size() < 3 || device_s.size() < 3)
    return {1.0, 0.0, HUGE_VAL, 0.0, false, "there are too few rows."};
  std::optional<Aligner> best;
  for (const double width_s : widths(reference_s)) {
    Aligner here(binned(reference_s, velocity, width_s), device_s, angle);
    if (!best || here.seen() > best->seen()) best.emplace(std::move(here));
  }
  return best->run();
}

}  // namespace searig::acquisition
