// One recording made ready for regression: motion, and the rows at which the paths are compared.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/diagnosis/rows/sampler.h"
#include "estimator/physics/motion.h"
#include "estimator/signals.h"

namespace searig::estimator {

/// Rows come in two blocks that are stacked, load cell first:
///
///   load-cell rows, at the load cell's samples:      T_loadcell = spring + rig (+ offset)
///   drive rows, 50 per second while the input moves: 0 = drive - spring
///
/// so that a fault in the spring shows in both, one in the drive only in the second, one in the
/// load cell or the rig only in the first. Without a spring channel the drive rows are at the load
/// cell's samples and compare drive + rig with T_loadcell.
struct Experiment {
  Motion motion;  ///< at most 300 samples per second; times from 0 at the first module sample
  double start_s = 0.0;

  std::vector<double> loadcell_t, drive_t;  ///< s, row times
  Eigen::VectorXd loadcell_nm;              ///< measured torque at loadcell_t
  Eigen::VectorXd measured;                 ///< right side, stacked
  std::vector<bool> usable;                 ///< stacked: inside the recording, moving, no spike
  std::vector<double> weight;  ///< stacked, 0..1: rows of one hold share one encoder error
  double loadcell_width_s = 0.02, drive_width_s = 0.02;  ///< averaging windows
  Sampler at_loadcell, at_drive;

  std::vector<double> part_starts_s{0.0};  ///< times from which the load cell has another zero
  double clock_sd_s = 0.0;  ///< what the clock map leaves open, one standard deviation
  double torque_rms = 0.0;  ///< of the load cell

  static constexpr double edge_s = 0.1;  ///< at both ends, where filters have too little to go by

  bool has_spring() const { return !loadcell_t.empty() && motion.has_spring(); }
  bool has_drive() const { return !drive_t.empty(); }
  Eigen::Index loadcell_rows() const { return has_spring() ? loadcell_nm.size() : 0; }
  Eigen::Index drive_rows() const { return Eigen::Index(drive_t.size()); }
  Eigen::Index rows() const { return loadcell_rows() + drive_rows(); }
  double time(Eigen::Index row) const;
  std::size_t part(Eigen::Index row) const;  ///< which of part_starts_s the row belongs to
};

/// Below this input speed the current says nothing about torque: the train sticks (contract).
inline constexpr double moving_rad_s = 0.03;

/// Throws std::invalid_argument where there is too little to compare.
Experiment prepare(const Signals& signals, double smoothing_rad_s);

}  // namespace searig::estimator
