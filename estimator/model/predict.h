// What a model says the torques were, given the measured angles, currents and temperatures.
#pragma once

#include <vector>

#include "estimator/model/model.h"
#include "estimator/signals.h"

namespace searig::estimator {

/// Torques in N*m at the module's own samples; empty where the recording lacks the channels.
struct Torques {
  std::vector<double> spring_nm;    ///< T_spring = k*theta + the other spring.* terms
  std::vector<double> drive_nm;     ///< T_drive = efficiency*(torque_constant*I - j*a) - friction
  std::vector<double> rig_nm;       ///< what the rig's terms take away between spring and load cell
  std::vector<double> loadcell_nm;  ///< (T_spring - rig) seen through the load cell's delay and lag
};

Torques predict(const Model& model, const ModuleSignals& module);

/// predict().drive_nm alone, without what it does not need. What a sample is given depends on the
/// samples within differentiator_half_width_s, unless a term of the spring with a memory loads
/// drive.load_friction.
std::vector<double> predict_drive(const Model& model, const ModuleSignals& module);

/// Half width of the local cubic that differentiates angles: wide enough that encoder steps do not
/// rule the acceleration, narrow enough to pass what an actuator does (-3 dB near 20 Hz).
inline constexpr double differentiator_half_width_s = 0.024;

/// The current at which the drive's torque is `spring_nm`, at the module's samples; empty where the
/// recording or the model cannot tell. Every drive term is straight in the current, so that two of
/// them say all.
std::vector<double> current_for(const Model& model, ModuleSignals module,
                                const std::vector<double>& spring_nm);

/// A signal given at module times (t, x), read at other times by linear interpolation; outside the
/// recording the nearest sample holds.
std::vector<double> sample_at(const std::vector<double>& t, const std::vector<double>& x,
                              const std::vector<double>& at);

}  // namespace searig::estimator
