// A motion to simulate, said in a few lines of TOML.
#pragma once

#include <filesystem>

#include "app/session/simulate.h"
#include "estimator/model/planned_motion.h"

namespace searig::app {

/// What a file of format "searig-spec/1" says:
///
///     format = "searig-spec/1"
///     model = "model.toml"          # beside this file; or [model.spring.linear] and so on here
///     [motion]
///     kind = "multisine"            # triangle, sine, multisine, staircase or hold
///     seconds = 60.0
///     amplitudes_rad = [0.05, 0.2]  # of the deflection; one after the other, each as long
///     frequencies_hz = [0.1, 1.0]   # beside them; the highest of a multisine, steps per second
///     output_rad = 0.3              # how far the lever swings by itself (default 0: locked)
///     [rates]
///     module_hz = 500.0
///     loadcell_hz = 50.0
///     [noise]
///     loadcell_nm = 0.01
///     current_a = 0.02
///     seed = 1
///     [temperature]                 # straight from the first to the second
///     spring_c = [25.0, 35.0]
///     winding_c = [25.0, 60.0]
struct MotionSpec {
  estimator::Model model;
  estimator::PlannedMotion motion;
  double module_hz = 500.0, loadcell_hz = 50.0;
  SimulatedNoise noise;
  std::vector<double> spring_c, winding_c;  ///< empty, or from and to
};

/// Throws std::invalid_argument with one sentence that names file and line.
MotionSpec read_motion_spec(const std::filesystem::path& file);

/// A spec with this motion and model, as text that read_motion_spec() takes.
std::string to_toml(const estimator::PlannedMotion& motion, const estimator::Model& model);

/// The motion as a recording without torques: both streams on one clock.
acquisition::Recording recording_of(const MotionSpec& spec);

}  // namespace searig::app
