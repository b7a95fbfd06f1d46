#include "tests/proving/rig/viscoelastic.h"

#include <cmath>

namespace searig::proving {
namespace {

class MaxwellBranches final : public Torque {
 public:
  explicit MaxwellBranches(std::vector<std::pair<double, double>> branches) {
    for (const auto& [k, tau] : branches) branches_.push_back({k, tau});
  }

  /// Exact for a deflection that is a straight line within the step.
  double advance(const Instant& now, double dt) override {
    const double step = now.deflection_rad - before_;
    before_ = now.deflection_rad;
    double total = 0.0;
    if (dt != dt_s_) prepare(dt);
    for (auto& b : branches_) {
      b.torque = b.torque * b.decay + b.gain * step;
      total += b.torque;
    }
    return total;
  }

 private:
  struct Branch {
    double k, tau, torque = 0.0, decay = 0.0, gain = 0.0;
  };

  void prepare(double dt) {
    dt_s_ = dt;
    for (auto& b : branches_) {
      b.decay = std::exp(-dt / b.tau);
      b.gain = b.k * (b.tau / dt) * (1.0 - b.decay);
    }
  }

  std::vector<Branch> branches_;
  double before_ = 0.0, dt_s_ = 0.0;
};

/// Scott Blair's springpot relaxes as t^-a. Between tau_min and tau_max, branches spaced evenly
/// in log(tau) with k_i ~ tau_i^-a give that power law to about a percent (Schapery & Park 1999).
std::vector<std::pair<double, double>> springpot_branches(double k, double exponent) {
  const double tau_min = 0.01, tau_max = 100.0;
  const int count = 10;
  std::vector<std::pair<double, double>> branches;
  for (int i = 0; i < count; ++i) {
    const double tau = tau_min * std::pow(tau_max / tau_min, i / (count - 1.0));
    branches.emplace_back(k * std::pow(tau, -exponent), tau);
  }
  return branches;
}

}  // namespace

std::unique_ptr<Torque> make_maxwell_branches(std::vector<std::pair<double, double>> branches) {
  return std::make_unique<MaxwellBranches>(std::move(branches));
}

std::unique_ptr<Torque> make_relaxation(const Effect& e) {
  if (e.form == "springpot")
    return make_maxwell_branches(springpot_branches(e.at("k1_nm_per_rad"), e.at("exponent")));
  std::vector<std::pair<double, double>> branches{{e.at("k1_nm_per_rad"), e.at("tau_s")}};
  for (const char* i : {"2", "3"})
    if (const double k = e.at_or(std::string("k") + i + "_nm_per_rad", 0.0); k != 0.0)
      branches.emplace_back(k, e.at(std::string("tau") + i + "_s"));
  return make_maxwell_branches(branches);
}

}  // namespace searig::proving
