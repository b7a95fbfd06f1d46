#include "estimator/evaluation/evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "estimator/evaluation/compare_estimators.h"
#include "estimator/evaluation/loop_error.h"
#include "estimator/evaluation/online_result.h"
#include "estimator/evaluation/stream_sampler.h"
#include "estimator/evaluation/survey.h"
#include "estimator/evaluation/telemetry.h"
#include "estimator/model/predict.h"

namespace searig::estimator {

namespace {

constexpr std::size_t rows_at_once = 65'536;  // of who watches: a minute at 1 kHz, a frame's work

void check(const Survey& survey) {
  if (survey.rows < 5) {
    throw std::invalid_argument("the recording holds fewer than five samples of the module");
  }
  if (survey.loadcell.t_s.size() < 5) {
    throw std::invalid_argument(
        "fewer than five load-cell samples lie within the module's telemetry");
  }
  if (!survey.has_deflection && !survey.has_current) {
    throw std::invalid_argument(
        "the module has neither deflection nor current: nothing to hold against the load cell");
  }
}

std::optional<BestFit> best_fit(const Survey& survey) {
  const auto& theta = survey.deflection_rad;
  const Line line = fit_line(theta, survey.loadcell.torque_nm);
  if (!std::isfinite(line.slope)) return std::nullopt;
  std::vector<double> estimate(theta.size());
  for (std::size_t i = 0; i < theta.size(); ++i) estimate[i] = line.slope * theta[i] + line.offset;
  return BestFit{line.slope, line.offset, score(estimate, survey.loadcell.torque_nm)};
}

void evaluate_spring(const Survey& survey, Evaluation& out) {
  if (!survey.has_deflection) {
    out.notes.push_back("no deflection: best fit and online estimate are switched off");
    return;
  }
  out.best_fit = best_fit(survey);
  if (!out.best_fit) {
    out.notes.push_back("the deflection never changes: best fit is switched off");
  } else if (out.best_fit->k_nm_per_rad <= 0) {
    out.notes.push_back(
        "the measured torque falls as the deflection grows: one of their signs is wrong, which "
        "scale = -1 in recording.toml mends");
  }
}

void note_current(const Survey& survey, const DriveRule& drive, Evaluation& out) {
  if (!survey.has_current) {
    out.notes.push_back("no motor current: motor current and online estimate are switched off");
  } else if (!drive.usable()) {
    out.notes.push_back("the motor current never changes: it cannot be held against the load cell");
  } else {
    out.drive_from = drive.from;
    out.drive_independent = !drive.fitted;
  }
}

DrivenRows driven(const TelemetryBlock& block, const DriveRule& drive) {
  const auto part = [&](const std::vector<double>& all) {
    if (all.empty()) return all;
    return std::vector<double>(all.begin() + std::ptrdiff_t(block.from),
                               all.begin() + std::ptrdiff_t(block.to));
  };
  return {part(block.rows.t_s), part(block.rows.deflection_rad), drive.nm(block)};
}

/// The second time through the telemetry: what needs a drive torque.
void follow(const Telemetry& telemetry, const Survey& survey, const DriveRule& drive,
            OnlineRun* online, const Watch& watch, Evaluation& out) {
  StreamSampler drive_at(survey.loadcell.t_s);
  const auto make = [&](const Watch::Give& give) {
    telemetry.go_through(differentiator_half_width_s,
                         [&](const TelemetryBlock& block) { give(driven(block, drive)); });
  };
  watch.pass(make, [&](const DrivenRows& rows) {
    for (std::size_t i = 0; i < rows.t_s.size(); ++i) {
      drive_at.push(rows.t_s[i], rows.drive_nm[i]);
      if (online) online->push(rows.t_s[i], rows.deflection_rad[i], rows.drive_nm[i]);
    }
    if (online && watch.track) watch.track(online->take_track());
  });
  auto estimate = drive_at.finish();
  for (double& torque : estimate) torque += drive.offset_nm;
  out.current = CurrentResult{drive.gain_nm_per_a, drive.offset_nm,
                              score(estimate, survey.loadcell.torque_nm)};
}

/// Telemetry with the control loop's error in the place of the current.
class LoopTelemetry : public Telemetry {
 public:
  LoopTelemetry(const Telemetry& telemetry, double gear_ratio, std::optional<double> gain)
      : telemetry_(telemetry), gear_ratio_(gear_ratio), gain_(gain) {}

  void go_through(double context_s, const Take& take) const override {
    telemetry_.go_through(context_s, [&](const TelemetryBlock& block) {
      Signals signals;
      signals.module = block.rows;
      signals.gear_ratio = gear_ratio_;
      missing_ = take_loop_error_for_current(signals, gain_);
      take({signals.module, block.from, block.to});
    });
  }

  /// What was missing, once it was gone through.
  const std::optional<std::string>& missing() const { return missing_; }

 private:
  const Telemetry& telemetry_;
  double gear_ratio_;
  std::optional<double> gain_;
  mutable std::optional<std::string> missing_;
};

struct Evaluated {
  Evaluation evaluation;
  Survey survey;
  DriveRule drive;
};

Evaluated evaluate_stream(const Telemetry& given, const LoadcellSignals& loadcell,
                          double gear_ratio, const Model* model, const EvaluationOptions& options,
                          Track track, const Watch& watch = {}) {
  const bool by_loop = options.drive == DriveTerms::loop;
  const bool knows_amperes = !by_loop || options.loop_gain_a_per_rad;
  const Model* drive_model = knows_amperes ? model : nullptr;
  const LoopTelemetry by_error(given, gear_ratio, options.loop_gain_a_per_rad);
  const Telemetry& telemetry = by_loop ? static_cast<const Telemetry&>(by_error) : given;

  Evaluated all;
  Evaluation& out = all.evaluation;
  const Survey& survey = all.survey =
      survey_of(telemetry, loadcell, fits_gain(drive_model) ? Weights::wanted : Weights::unwanted);
  if (by_loop && by_error.missing()) out.notes.push_back(*by_error.missing());
  check(survey);
  all.drive = drive_rule(survey, drive_model, options.drive);
  if (const auto left_out = loadcell.t_s.size() - survey.loadcell.t_s.size()) {
    out.notes.push_back(std::to_string(left_out) +
                        " load-cell samples are left out: no telemetry at their time");
  }
  out.seconds = survey.last_s - survey.first_s;
  evaluate_spring(survey, out);
  note_current(survey, all.drive, out);
  if (!all.drive.usable()) return all;

  std::optional<OnlineRun> online;
  if (survey.has_deflection) {
    if (const auto start = online_start(model, options, out.best_fit, out.notes))
      online.emplace(*start, options, out.best_fit, survey.loadcell.t_s, track);
  }
  follow(telemetry, survey, all.drive, online ? &*online : nullptr, watch, out);
  if (online) out.online = online->finish(survey, out.notes);
  return all;
}

}  // namespace

std::string needs_whole(const Model* model, const EvaluationOptions& options) {
  if (!options.estimators.empty()) return "several estimators are compared";
  if (!model || !model->has("drive.load_friction")) return {};
  for (const char* effect : {"spring.hysteresis", "spring.relaxation", "spring.mullins"})
    if (model->has(effect))
      return "the load on the drive's friction depends on the whole past of " + std::string(effect);
  return {};
}

Evaluation evaluate(const Telemetry& telemetry, const LoadcellSignals& loadcell, double gear_ratio,
                    const Model* model, const EvaluationOptions& options) {
  return evaluate_stream(telemetry, loadcell, gear_ratio, model, options, Track::dropped)
      .evaluation;
}

Evaluation evaluate(const Signals& recorded, const Model* model, const EvaluationOptions& options) {
  const WholeTelemetry telemetry(recorded.module);
  Evaluated all = evaluate_stream(telemetry, recorded.loadcell, recorded.gear_ratio, model, options,
                                  Track::kept);
  Evaluation& out = all.evaluation;
  if (!out.online || options.estimators.empty()) return out;
  Signals signals = recorded;
  signals.loadcell = all.survey.loadcell;
  if (options.drive == DriveTerms::loop)
    take_loop_error_for_current(signals, options.loop_gain_a_per_rad);
  const std::vector<double> drive_nm = all.drive.nm({signals.module, 0, signals.module.t_s.size()});
  out.estimators = compare_estimators(signals, model, drive_nm, options, *out.online, out.notes);
  return out;
}

Evaluation evaluate(const Signals& signals, const Model* model, const EvaluationOptions& options,
                    const Watch& watch) {
  const bool whole = !needs_whole(model, options).empty();
  const WholeTelemetry telemetry(signals.module, whole ? signals.module.t_s.size() : rows_at_once);
  return evaluate_stream(telemetry, signals.loadcell, signals.gear_ratio, model, options,
                         Track::kept, watch)
      .evaluation;
}

}  // namespace searig::estimator
