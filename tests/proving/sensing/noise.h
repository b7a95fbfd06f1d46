#pragma once

#include <string>

#include "tests/proving/random.h"

namespace searig::proving {

/// What the load cell and the current sensor add to the truth.
struct NoisePlan {
  double loadcell_rms_nm = 0.01;
  std::string loadcell_kind =
      "white";  ///< white, ar0.6, ar0.9, ar0.97, hum, loud_when_loaded, outliers
  double current_rms_a = 0.02;
  double temperature_rms_c = 0.1;
};

/// One torque sensor's noise, sample after sample.
class LoadcellNoise {
 public:
  LoadcellNoise(const NoisePlan& plan, double torque_rms_nm, Random random);
  double next(double t_s, double torque_nm);

 private:
  double rms_nm_, torque_rms_nm_;
  double memory_ = 0.0, hum_share_ = 0.0, hum_hz_ = 50.0, hum_phase_rad_ = 0.0;
  double loaded_share_ = 0.0, outlier_chance_ = 0.0;
  double state_ = 0.0;
  Random random_;
};

}  // namespace searig::proving
