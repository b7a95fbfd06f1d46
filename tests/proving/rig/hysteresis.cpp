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

/// A sum of relays (Preisach 1935), each switching up at alpha and down at beta < alpha, with
/// weights that fall off away from the diagonal alpha - beta = 2*yield_rad. Each relay turns over
/// within a small softness, or its clicks would be heard.
class Preisach final : public Torque {
 public:
  Preisach(double torque_nm, double yield_rad, double reach_rad, int side) {
    double weights = 0.0;
    const double step = 2.0 * reach_rad / side;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < i; ++j) {
        const double up = -reach_rad + (i + 0.5) * step, down = -reach_rad + (j + 0.5) * step;
        const double width = (up - down) / (2.0 * yield_rad);
        const double weight = width * std::exp(-width * width);
        if (weight < 1e-4) continue;
        relays_.push_back({up, down, weight, -1.0});
        weights += weight;
      }
    for (auto& r : relays_) r.weight *= torque_nm / weights;
    softness_rad_ = step;
    for (std::size_t i = 0; i < relays_.size(); i += 2) relays_[i].state = 1.0;  // demagnetised
  }

  double advance(const Instant& now, double) override {
    double total = 0.0;
    for (auto& r : relays_) {
      r.state =
          std::max(r.state, std::clamp((now.deflection_rad - r.up) / softness_rad_, -1.0, 1.0));
      r.state =
          std::min(r.state, std::clamp((now.deflection_rad - r.down) / softness_rad_, -1.0, 1.0));
      total += r.weight * r.state;
    }
    return total;
  }

 private:
  struct Relay {
    double up, down, weight, state;
  };
  std::vector<Relay> relays_;
  double softness_rad_ = 1e-4;
};

}  // namespace

std::unique_ptr<Torque> make_hysteresis(const Effect& e) {
  const double torque = e.at("torque_nm"), yield = e.at("yield_rad");
  if (e.form == "maxwell_slip")
    return std::make_unique<MaxwellSlip>(torque, yield, e.at("spread"), 12);
  if (e.form == "bouc_wen")
    return std::make_unique<BoucWen>(torque, yield, e.at("beta"), e.at("exponent"));
  if (e.form == "preisach") return std::make_unique<Preisach>(torque, yield, e.at("reach_rad"), 18);
  throw std::invalid_argument("no hysteresis has the form " + e.form);
}

}  // namespace searig::proving
