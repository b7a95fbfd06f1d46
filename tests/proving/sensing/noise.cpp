#include "tests/proving/sensing/noise.h"

#include <cmath>
#include <numbers>

namespace searig::proving {

LoadcellNoise::LoadcellNoise(const NoisePlan& plan, double torque_rms_nm, Random random)
    : rms_nm_(plan.loadcell_rms_nm), torque_rms_nm_(torque_rms_nm), random_(random) {
  const std::string& kind = plan.loadcell_kind;
  if (kind.starts_with("ar")) memory_ = std::stod(kind.substr(2));
  if (kind == "hum") {
    hum_share_ = 0.6;
    hum_hz_ =
        50.0 * (1.0 + random_.uniform(-1.5e-3, 1.5e-3));  // the grid, sampled without a filter
    hum_phase_rad_ = random_.uniform(0.0, 2.0 * std::numbers::pi);
  }
  if (kind == "loud_when_loaded") loaded_share_ = 1.0;
  if (kind == "outliers") outlier_chance_ = 0.0015;
  state_ = random_.normal();
}

double LoadcellNoise::next(double t_s, double torque_nm) {
  state_ = memory_ * state_ + std::sqrt(1.0 - memory_ * memory_) * random_.normal();
  double noise = state_ * std::sqrt(1.0 - hum_share_ * hum_share_);
  noise += hum_share_ * std::sqrt(2.0) *
           std::sin(2.0 * std::numbers::pi * hum_hz_ * t_s + hum_phase_rad_);
  if (loaded_share_ > 0.0)  // half the variance at rest, the rest with the torque
    noise *= std::sqrt(0.5 + 0.5 * std::pow(torque_nm / torque_rms_nm_, 2));
  if (random_.chance(outlier_chance_)) noise += random_.sign() * random_.uniform(8.0, 22.0);
  return rms_nm_ * noise;
}

}  // namespace searig::proving
