#include "tests/proving/rig/gauge.h"

#include <cmath>
#include <deque>

namespace searig::proving {
namespace {

/// What was there delay_s ago, between two steps by a straight line.
class Delay final : public Gauge {
 public:
  explicit Delay(double delay_s) : delay_s_(delay_s) {}
  double advance(double torque, const Instant&, double dt) override {
    past_.push_front(torque);
    const double steps = delay_s_ / dt;
    const auto whole = static_cast<std::size_t>(steps);
    if (past_.size() > whole + 2) past_.pop_back();
    if (past_.size() < whole + 2) return past_.back();
    return past_[whole] + (steps - static_cast<double>(whole)) * (past_[whole + 1] - past_[whole]);
  }

 private:
  double delay_s_;
  std::deque<double> past_;
};

/// poles equal first-order low passes in a row, tau_s altogether.
class LowPass final : public Gauge {
 public:
  LowPass(double tau_s, int poles)
      : tau_s_(tau_s / poles), states_(static_cast<std::size_t>(poles), 0.0) {}
  double advance(double torque, const Instant&, double dt) override {
    for (double& state : states_)
      torque = state += (torque - state) * (1.0 - std::exp(-dt / tau_s_));
    return torque;
  }

 private:
  double tau_s_;
  std::vector<double> states_;
};

/// The mean over the last 2*tau_s: it is tau_s late, as a low pass of tau_s is.
class MovingAverage final : public Gauge {
 public:
  explicit MovingAverage(double tau_s) : tau_s_(tau_s) {}
  double advance(double torque, const Instant&, double dt) override {
    past_.push_back(torque);
    sum_ += torque;
    if (static_cast<double>(past_.size()) * dt > 2.0 * tau_s_) {
      sum_ -= past_.front();
      past_.pop_front();
    }
    return sum_ / static_cast<double>(past_.size());
  }

 private:
  double tau_s_, sum_ = 0.0;
  std::deque<double> past_;
};

class ZeroDrift final : public Gauge {
 public:
  ZeroDrift(double nm_per_min, double settles_s)
      : per_s_(nm_per_min / 60.0), settles_s_(settles_s) {}
  double advance(double torque, const Instant& now, double) override {
    const double t = now.t_s;
    return torque + per_s_ * (settles_s_ > 0.0 ? -settles_s_ * std::expm1(-t / settles_s_) : t);
  }

 private:
  double per_s_, settles_s_;  // settles_s > 0: an amplifier that warms up and slows down
};

}  // namespace

std::unique_ptr<Gauge> make_gauge(const Effect& e) {
  if (e.name == "rig.delay") return std::make_unique<Delay>(e.at("delay_s"));
  if (e.name == "rig.zero_drift")
    return std::make_unique<ZeroDrift>(e.at("nm_per_min"), e.at_or("settles_s", 0.0));
  if (e.name != "rig.lag") return nullptr;
  if (e.form == "moving_average") return std::make_unique<MovingAverage>(e.at("tau_s"));
  return std::make_unique<LowPass>(e.at("tau_s"), e.form == "critically_damped" ? 2 : 1);
}

}  // namespace searig::proving
