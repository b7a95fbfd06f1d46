// The online estimate over a whole recording.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "estimator/evaluation/evaluation.h"
#include "estimator/evaluation/stream_sampler.h"
#include "estimator/evaluation/survey.h"

namespace searig::estimator {

/// Where the online estimate starts: options.initial_k, else the model's stiffness, else the best
/// fit; notes say which. Nothing where no start can be had.
std::optional<double> online_start(const Model* model, const EvaluationOptions& options,
                                   const std::optional<BestFit>& best_fit,
                                   std::vector<std::string>& notes);

/// Whether the estimate of each sample is kept.
enum class Track { dropped, kept };

/// The online estimator along the telemetry, and what becomes of it, without the track of it being
/// kept unless asked for.
class OnlineRun {
 public:
  /// `loadcell_s` must outlive it.
  OnlineRun(double initial_k_nm_per_rad, const EvaluationOptions& options,
            const std::optional<BestFit>& best_fit, std::span<const double> loadcell_s,
            Track track);

  void push(double t_s, double deflection_rad, double drive_nm);

  /// What has been kept of the track since the last call; until the next one, or a push().
  std::span<const OnlineEstimate> take_track();

  /// After the last sample. Nothing, and a note, where none could be used.
  std::optional<OnlineResult> finish(const Survey& survey, std::vector<std::string>& notes);

 private:
  void take(const OnlineEstimate& estimate);
  bool near(double k_nm_per_rad) const;

  OnlineStiffness online_;
  OnlineResult out_;
  std::optional<double> best_k_;
  StreamSampler k_at_;
  Track track_;
  std::vector<OnlineEstimate> taken_;
  std::optional<OnlineEstimate> before_;
  double first_s_ = 0;
  Convergence so_far_{0, 0};
};

}  // namespace searig::estimator
