// The paper's Table I for one recording: best fit, online estimate and motor current against the
// load cell.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "estimator/evaluation/drive_torque.h"
#include "estimator/evaluation/score.h"
#include "estimator/evaluation/telemetry.h"
#include "estimator/filter/online_stiffness.h"
#include "estimator/filter/state_estimator.h"
#include "estimator/model/model.h"
#include "estimator/signals.h"

namespace searig::estimator {

struct EvaluationOptions {
  std::optional<double> initial_k_nm_per_rad =
      {};  ///< of the online estimate; otherwise a good one
  DriveTerms drive = DriveTerms::model;
  bool exactly_as_the_paper =
      false;  ///< gamma, alpha and beta as printed, for a module of any size
  std::optional<double> loop_gain_a_per_rad = {};       ///< for DriveTerms::loop; otherwise fitted
  std::vector<EstimatorKind> estimators = {};           ///< to compare, besides the online estimate
  std::vector<std::string> states = {"spring.linear"};  ///< of these, see SpringStates
};

/// The least-squares line of measured torque on deflection: what no online method knows.
struct BestFit {
  double k_nm_per_rad;
  double offset_nm;  ///< of the load cell or of the deflection
  Score score;
};

/// When the online estimate came within 5 % of the best fit for good.
struct Convergence {
  double after_s;         ///< from the start of the recording
  double trust_weight_s;  ///< the sum of trust weight times time until then
};

struct OnlineResult {
  double initial_k_nm_per_rad;
  double k_nm_per_rad;    ///< the last
  Score score;            ///< of k theta, with the k of that moment
  double trust_weight_s;  ///< the sum of trust weight times time over the recording
  std::optional<Convergence> convergence;
  std::vector<OnlineEstimate>
      track;  ///< at every telemetry sample; empty where that is streamed or watched
};

/// One of the estimators that were asked for.
struct EstimatorResult {
  EstimatorKind kind;
  Score score;                             ///< of phi'x, with the x of that moment
  std::vector<StateParameter> parameters;  ///< the last
  std::string why_no_interval;             ///< empty where each parameter has its 95 % interval
};

struct CurrentResult {
  double gain_nm_per_a;  ///< efficiency * torque constant
  double offset_nm;      ///< where the gain was fitted, of the load cell; else 0
  Score score;
};

struct Evaluation {
  double seconds = 0;  ///< of the module's telemetry
  std::optional<BestFit> best_fit;
  std::optional<OnlineResult> online;
  std::optional<CurrentResult> current;
  std::vector<EstimatorResult> estimators;  ///< in the order of the options
  std::string drive_from;                   ///< what the drive torque was made of
  bool drive_independent = false;           ///< of the load cell
  std::vector<std::string> notes;           ///< what was switched off and why; one sentence each
};

/// All errors are taken at the load cell's own samples, of those that the module's telemetry
/// covers: at one of its times, or between two without a gap.
/// Throws std::invalid_argument with one sentence where there is nothing to compare with.
Evaluation evaluate(const Signals& signals, const Model* model = nullptr,
                    const EvaluationOptions& options = {});

/// Telemetry with the torque of its drive: columns of one size.
struct DrivenRows {
  std::vector<double> t_s, deflection_rad, drive_nm;
};

/// Whoever watches the online estimate come.
struct Watch {
  using Give = std::function<void(DrivenRows)>;
  using Make = std::function<void(const Give&)>;

  /// Stretch after stretch of what is then no longer in OnlineResult::track. What it throws ends
  /// the evaluation and comes out of it.
  std::function<void(std::span<const OnlineEstimate>)> track;
  /// Lets make() give all that is to be taken, in order. The estimator starts no threads; who has
  /// one to spare lets the torques of the next rows be worked out in it.
  std::function<void(const Make& make, const Give& take)> pass =
      [](const Make& make, const Give& take) { make(take); };
};

/// As evaluate() of the same signals, to the bit but for drive.stribeck.
Evaluation evaluate(const Signals& signals, const Model* model, const EvaluationOptions& options,
                    const Watch& watch);

/// The same of telemetry that is not in memory: it is gone through twice. The same to the bit but
/// for drive.stribeck, whose exponential the compiler may round otherwise by the last bit.
Evaluation evaluate(const Telemetry& telemetry, const LoadcellSignals& loadcell, double gear_ratio,
                    const Model* model, const EvaluationOptions& options);

/// Why only the whole in memory will do, or empty.
std::string needs_whole(const Model* model, const EvaluationOptions& options);

}  // namespace searig::estimator
