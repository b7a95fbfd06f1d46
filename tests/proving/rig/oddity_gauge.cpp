#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/proving/random.h"
#include "tests/proving/rig/oddity.h"

namespace searig::proving {
namespace {

template <typename Formula>
class FormulatedGauge final : public Gauge {
 public:
  explicit FormulatedGauge(Formula formula) : formula_(std::move(formula)) {}
  double advance(double torque, const Instant& now, double) override {
    return formula_(torque, now);
  }

 private:
  Formula formula_;
};

template <typename Formula>
std::unique_ptr<Gauge> gauge(Formula formula) {
  return std::make_unique<FormulatedGauge<Formula>>(std::move(formula));
}

/// The zero does a random walk of nm_per_sqrt_s.
class RandomWalk final : public Gauge {
 public:
  RandomWalk(double nm_per_sqrt_s, double seed)
      : nm_per_sqrt_s_(nm_per_sqrt_s), random_(static_cast<std::uint64_t>(seed)) {}
  double advance(double torque, const Instant& now, double dt) override {
    if (now.t_s >= 0.0) zero_nm_ += nm_per_sqrt_s_ * std::sqrt(dt) * random_.normal();
    return torque + zero_nm_;
  }

 private:
  double nm_per_sqrt_s_, zero_nm_ = 0.0;
  Random random_;
};

/// The line goes dead: the converter repeats its last value from `from` to `to`.
class Frozen final : public Gauge {
 public:
  Frozen(double from_s, double to_s) : from_s_(from_s), to_s_(to_s) {}
  double advance(double torque, const Instant& now, double) override {
    if (now.t_s < from_s_ || now.t_s > to_s_) last_ = torque;
    return last_;
  }

 private:
  double from_s_, to_s_, last_ = 0.0;
};

double fade(double t, double from, double to, double edge) {
  const double x = std::clamp(std::min(t - from, to - t) / edge, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace

std::unique_ptr<Gauge> make_odd_gauge(const Effect& e) {
  const double from = e.at_or("from_s", 0.0), to = e.at_or("to_s", 0.0);
  if (e.form == "zero_random_walk")
    return std::make_unique<RandomWalk>(e.at("nm_per_sqrt_s"), e.at("seed"));
  if (e.form == "frozen_reading") return std::make_unique<Frozen>(from, to);
  if (e.form == "zero_step")
    return gauge([=, step = e.at("torque_nm")](double torque, const Instant& now) {
      return torque + (now.t_s >= from ? step : 0.0);
    });
  if (e.form == "saturation")  // one-sided: the amplifier runs into its rail
    return gauge(
        [peak = e.at("peak_nm"), depth = e.at("depth_share")](double torque, const Instant&) {
          return std::min(torque, peak * (1.0 - depth));
        });
  if (e.form == "gain_fault")  // a corroded contact halves the bridge's supply for a while
    return gauge([=, share = e.at("share")](double torque, const Instant& now) {
      return torque * (1.0 - share * fade(now.t_s, from, to, 0.2));
    });
  if (e.form == "cable_tremor")  // a cable swings at its own frequency while it is touched
    return gauge([=, a = e.at("torque_nm"), hz = e.at("hz")](double torque, const Instant& now) {
      return torque +
             a * fade(now.t_s, from, to, 1.0) * std::sin(2.0 * std::numbers::pi * hz * now.t_s);
    });
  if (e.form == "missing_codes")  // within a band of torque the converter's low bits stick
    return gauge([=, low = e.at("low_nm"), high = e.at("high_nm"), code = e.at("code_nm")](
                     double torque, const Instant&) {
      return torque > low && torque < high ? low + code * std::floor((torque - low) / code)
                                           : torque;
    });
  return nullptr;
}

}  // namespace searig::proving
