// A recording whose truth is known: its spring is damped, and the model beside it knows none.
#pragma once

#include <filesystem>

#include "acquisition/recording/text_file.h"
#include "acquisition/recording/write_recording.h"
#include "app/session/motion_spec.h"

namespace searig::app {

inline constexpr double sample_k = 40.0, sample_c = 0.6, sample_seconds = 40.0;

/// Makes `folder` of it. There is a drive, so that an online estimate can be made.
inline void make_sample_recording(const std::filesystem::path& folder) {
  MotionSpec spec;
  spec.model.set("spring.linear", "k_nm_per_rad", sample_k);
  spec.model.set("drive.motor", "torque_constant_nm_per_a", 2.6);
  spec.model.set("drive.motor", "efficiency", 0.75);
  const std::string believed = estimator::to_toml(spec.model);
  spec.model.set("spring.viscous", "c_nm_s_per_rad", sample_c);
  spec.motion.seconds = sample_seconds;
  spec.motion.amplitudes_rad = {0.1, 0.2};
  spec.motion.frequencies_hz = {1.0};
  spec.motion.output_rad = 0.2;
  spec.module_hz = 200.0;
  spec.noise = {0.02, 0.02, 1};
  const Session like = session_of(recording_of(spec));
  acquisition::write_recording(simulate(spec.model, like, spec.noise).recording, folder);
  acquisition::write_text_file(folder / "model.toml", believed);
}

}  // namespace searig::app
