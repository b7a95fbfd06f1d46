#include "tests/proving/rig/hysteresis.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace searig::proving {
namespace {

/// Springs in parallel, each sliding at its own torque (Iwan 1966); yields spread about yield_rad.
class MaxwellSlip final : public Torque {
 public:
  MaxwellSlip(double torque_nm, double yield_rad, double spread, int count) {
    for (int i = 0; i < count; ++i) {
      const double yield = yield_rad * (1.0 + spread * (2.0 * (i + 0.5) / count - 1.0));
      const double limit = torque_nm / count;
      elements_.push_back({limit / yield, limit, 0.0});
    }
  }

  double advance(const Instant& now, double) override {
    const double step = now.deflection_rad - before_;
    before_ = now.deflection_rad;
    double total = 0.0;
    for (auto& e : elements_) {
      e.torque = std::clamp(e.torque + e.stiffness * step, -e.limit, e.limit);
      total += e.torque;
    }
    return total;
  }

 private:
  struct Element {
    double stiffness, limit, torque;
  };
  std::vector<Element> elements_;
  double before_ = 0.0;
};

/// Bouc 1967, Wen 1976: y*dz/dt = dtheta/dt - b*|dtheta/dt|*|z|^(n-1)*z - g*dtheta/dt*|z|^n, b+g=1.
class BoucWen final : public Torque {
 public:
  BoucWen(double torque_nm, double yield_rad, double beta, double n)
      : torque_nm_(torque_nm), yield_rad_(yield_rad), beta_(beta), n_(n) {}

  double advance(const Instant& now, double) override {
    const double step = (now.deflection_rad - before_) / yield_rad_;
    before_ = now.deflection_rad;
    const double magnitude = std::pow(std::abs(z_), n_);
    const double towards = step * z_ > 0.0 ? 1.0 : 1.0 - 2.0 * beta_;  // loading, else unloading
    z_ = std::clamp(z_ + step * (1.0 - towards * magnitude), -1.0, 1.0);
    return torque_nm_ * z_;
  }

 private:
  double torque_nm_, yield_rad_, beta_, n_;
  double z_ = 0.0, before_ = 0.0;
};

/// Relays (Preisach 1935), each switching up at alpha and down at beta < alpha, weighted about
/// widths of 2*yield_rad. Their sum lags the deflection as magnetisation lags a field; a lossy
/// spring leads it, so the torque is a straight line minus the relays;
/// it rises with the slope of the sum's middle and so saturates at torque_nm there.
class Preisach final : public Torque {
 public:
  Preisach(double torque_nm, double yield_rad, double reach_rad, int side) {
    const double step = 2.0 * reach_rad / side;
    double weights = 0.0, half_widths = 0.0, per_step = 0.0;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < i; ++j) {
        const double up = (i + 0.5) * step - reach_rad, down = (j + 0.5) * step - reach_rad;
        const double width = (up - down) / (2.0 * yield_rad);
        const double weight = width * std::exp(-width * width);
        if (weight < 1e-3) continue;
        relays_.push_back({up, down, weight, up + down > 0.0 ? -1.0 : 1.0});  // demagnetised
        weights += weight;
        if (i == side - 1) per_step += weight;  // every width once
        half_widths += weight * 0.5 * (up - down);
      }
    for (auto& r : relays_) r.weight /= weights;
    softness_rad_ = step;  // each relay turns over gently, or its clicks would be heard
    slope_per_rad_ = 2.0 * per_step / weights / step;
    scale_nm_ = torque_nm / (slope_per_rad_ * half_widths / weights);
  }

  double advance(const Instant& now, double) override {
    double sum = 0.0;
    for (auto& r : relays_) {
      const double up = (now.deflection_rad - r.up) / softness_rad_;
      const double down = (now.deflection_rad - r.down) / softness_rad_;
      r.state = std::min(std::max(r.state, std::clamp(up, -1.0, 1.0)), std::clamp(down, -1.0, 1.0));
      sum += r.weight * r.state;
    }
    return scale_nm_ * (slope_per_rad_ * now.deflection_rad - sum);
  }

 private:
  struct Relay {
    double up, down, weight, state;
  };
  std::vector<Relay> relays_;
  double softness_rad_ = 0.0, slope_per_rad_ = 0.0, scale_nm_ = 0.0;
};

}  // namespace

std::unique_ptr<Torque> make_hysteresis(const Effect& e) {
  const double torque = e.at("torque_nm"), yield = e.at("yield_rad");
  if (e.form == "maxwell_slip")
    return std::make_unique<MaxwellSlip>(torque, yield, e.at("spread"), 12);
  if (e.form == "bouc_wen")
    return std::make_unique<BoucWen>(torque, yield, e.at("beta"), e.at("exponent"));
  if (e.form == "preisach") return std::make_unique<Preisach>(torque, yield, e.at("reach_rad"), 36);
  throw std::invalid_argument("no hysteresis has the form " + e.form);
}

}  // namespace searig::proving
