// Where a recording and its simulation differ, what physics is missing, and what it brings.
//
// The recording is cut into the rows of experiment.h; terms are columns on them (bench.h); noise is
// autoregressive (noise.h); search.h adds the terms that pass; what is left is held against a dense
// map and against features that have no name. The method is told in docs/diagnosis.md.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "estimator/diagnosis/method.h"
#include "estimator/model/model.h"
#include "estimator/model/planned_motion.h"
#include "estimator/signals.h"

namespace searig::estimator {

enum class Verdict { consistent, recalibrate, missing_physics, unexplained };

struct Alternative {
  std::string effect;  ///< a name of the catalogue, or empty for "something without a name"
  double probability = 0.0;
  std::string separated_by;
};

/// A parameter as the model file names it, with its 95 % interval.
struct ParameterEstimate {
  std::string effect, name;
  double value = 0.0, lower = 0.0, upper = 0.0;

  /// Whether a number that was given may stand: it lies within the interval, widened by half of it
  /// and by one percent of the value for what filters and sampling do to any number.
  bool allows(double given) const {
    return std::abs(given - value) <= 1.5 * (upper - value) + 0.01 * std::abs(value);
  }
};

/// Part of a channel's range ("deflection_rad") in which most of a mismatch lies.
struct Region {
  std::string channel;
  double from = 0.0, to = 0.0;
};

struct Located {
  std::vector<std::string> residuals;  ///< "loadcell-spring", "loadcell-drive", "drive-spring"
  double share = 0.0;                  ///< of before^2 - noise^2, on held-out data
  std::vector<Region> regions;
  std::vector<std::pair<double, double>> intervals_s;  ///< on the module's clock
};

/// rms of the difference at the load cell's samples, N*m; see the contract.
struct PathErrors {
  std::optional<double> as_given;
  double before = 0.0, after = 0.0, noise_floor = 0.0;
};

struct Finding {
  std::string effect;
  double probability = 0.0;
  std::vector<Alternative> alternatives;
  std::vector<ParameterEstimate> parameters;
  Located located;
  double before_nm = 0.0, after_nm = 0.0;  ///< held out, in the path it enters, without and with it
  std::string next_experiment;             ///< in words
  std::optional<PlannedMotion> next_motion;  ///< the same for a rig, where a motion helps
};

struct Unexplained {
  Located located;
  double p_value = 0.0;
  std::string what;  ///< in words, as far as it can be said
};

struct Undecidable {
  std::vector<std::string> effects;
  std::string why, needs;
};

/// Residuals for plots, at the load cell's samples.
struct Traces {
  std::vector<double> t_s;                                             ///< on the module's clock
  std::vector<double> measured_nm, spring_before_nm, spring_after_nm;  ///< residuals, not torques
  std::vector<double> drive_before_nm, drive_after_nm;                 ///< NaN while it sticks
};

/// One cell of the dense map: mean residual over its standard error, before and after.
struct Cell {
  std::string residual;
  Region region;
  double before = 0.0, after = 0.0;
};

struct Diagnosis {
  Verdict verdict = Verdict::consistent;
  std::vector<Finding> findings;
  std::optional<Unexplained> unexplained;
  std::optional<PathErrors> spring, drive;
  std::vector<Undecidable> undecidable;
  std::vector<ParameterEstimate> numbers;  ///< of the terms the model already had, refitted
  std::vector<std::string> notes;          ///< what was switched off, and why
  Model extended;                          ///< the model with refitted numbers and all findings
  Traces traces;
  std::vector<Cell> map;
};

/// Called between steps with a sentence and the share that is done; return false to stop, and
/// diagnose() throws std::runtime_error("cancelled").
using Progress = std::function<bool(const std::string& doing, double share)>;

/// Throws std::invalid_argument where there is too little to compare. Without a model, the paper's
/// two equations with unknown numbers. Deterministic; starts no thread. `method` is for negative
/// controls.
Diagnosis diagnose(const Signals& signals, const std::optional<Model>& model,
                   const Progress& progress = {}, const Method& method = {});

}  // namespace searig::estimator
