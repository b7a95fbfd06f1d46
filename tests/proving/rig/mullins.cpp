#include "tests/proving/rig/mullins.h"

#include <algorithm>
#include <cmath>

namespace searig::proving {
namespace {

/// Ogden & Roxburgh 1999: T = eta*k*theta, eta = 1 - (1/r)*erf((W_max - W)/m), W = k*theta^2/2.
/// On the virgin curve W = W_max and nothing is lost; every return below it is softer.
class OgdenRoxburgh final : public Torque {
 public:
  OgdenRoxburgh(double k, double share, double energy_j) : k_(k), share_(share), m_(energy_j) {}

  double advance(const Instant& now, double) override {
    const double w = 0.5 * k_ * now.deflection_rad * now.deflection_rad;
    largest_j_ = std::max(largest_j_, w);
    return -share_ * std::erf((largest_j_ - w) / m_) * k_ * now.deflection_rad;
  }

 private:
  double k_, share_, m_, largest_j_ = 0.0;
};

/// Continuum damage driven by the largest deflection so far (Miehe 1995):
/// D = share*(1 - exp(-theta_max/scale)).
class LargestDeflection final : public Torque {
 public:
  LargestDeflection(double k, double share, double scale_rad)
      : k_(k), share_(share), scale_rad_(scale_rad) {}

  double advance(const Instant& now, double) override {
    largest_rad_ = std::max(largest_rad_, std::abs(now.deflection_rad));
    return share_ * std::expm1(-largest_rad_ / scale_rad_) * k_ * now.deflection_rad;
  }

 private:
  double k_, share_, scale_rad_, largest_rad_ = 0.0;
};

}  // namespace

std::unique_ptr<Torque> make_mullins(const Effect& e, double k) {
  if (e.form == "ogden_roxburgh")
    return std::make_unique<OgdenRoxburgh>(k, e.at("share"), e.at("energy_j"));
  return std::make_unique<LargestDeflection>(k, e.at("share"), e.at("scale_rad"));
}

}  // namespace searig::proving
