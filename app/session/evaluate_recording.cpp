#include "app/session/evaluate_recording.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/module_rows.h"
#include "app/session/hand_over.h"
#include "app/session/session.h"

namespace searig::app {
namespace {

using acquisition::ClockMap;
using acquisition::ModuleRows;
using acquisition::Recording;
using estimator::Evaluation;
using estimator::EvaluationOptions;
using estimator::Model;

class StreamedTelemetry : public estimator::Telemetry {
 public:
  StreamedTelemetry(const ModuleRows& rows, std::vector<std::string> channels, bool read_ahead)
      : rows_(rows), channels_(std::move(channels)), read_ahead_(read_ahead) {}

  void go_through(double context_s, const Take& take) const override {
    estimator::BlockMaker blocks(context_s, take);
    first_s_ = HUGE_VAL;
    const auto add = [&](const estimator::ModuleSignals& piece) {
      first_s_ = std::min(first_s_, piece.t_s.front());
      last_s_ = piece.t_s.back();
      blocks.add(piece);
    };
    if (read_ahead_)
      while_read_ahead(add);
    else
      rows_.go_through(channels_, [&](const acquisition::Stream& piece) {
        if (!piece.t_s.empty()) add(signals_of(piece));
      });
    blocks.finish();
  }

  // Once it was gone through.
  double first_s() const { return first_s_; }
  double last_s() const { return last_s_; }

 private:
  /// One thread reads while the caller's works on what was read.
  template <class Add>
  void while_read_ahead(Add add) const {
    const auto read = [&](const auto& give) {
      rows_.go_through(channels_, [&](const acquisition::Stream& piece) {
        if (!piece.t_s.empty()) give(signals_of(piece));
      });
    };
    make_ahead<estimator::ModuleSignals>(read, add);
  }

  const ModuleRows& rows_;
  std::vector<std::string> channels_;
  bool read_ahead_;
  mutable double first_s_ = HUGE_VAL, last_s_ = -HUGE_VAL;
};

/// The channels that an evaluation looks at.
std::vector<std::string> channels_for(const ModuleRows& rows, const std::optional<Model>& model,
                                      const EvaluationOptions& options) {
  std::vector<std::string> channels{"deflection_rad", "current_a"};
  const bool by_loop = options.drive == estimator::DriveTerms::loop;
  const bool by_model = model && model->has("drive.motor");
  if (by_model || by_loop || !rows.has("deflection_rad")) channels.push_back("input_angle_rad");
  if (!rows.has("deflection_rad")) channels.push_back("output_angle_rad");
  if (by_loop) channels.insert(channels.end(), {"motor_angle_rad", "commanded_angle_rad"});
  if (by_model)
    channels.insert(channels.end(),
                    {"input_velocity_rad_s", "winding_temperature_c", "spring_temperature_c"});
  return channels;
}

EvaluatedRecording with_notes(Evaluation evaluation, const Recording& recording,
                              const ClockMap& clock, bool streamed) {
  EvaluatedRecording out{std::move(evaluation), {}, streamed};
  out.notes = out.evaluation.notes;
  if (!recording.cut_off.empty()) out.notes.push_back(recording.cut_off);
  if (!clock.trusted) out.notes.push_back("the clocks are not to be trusted: " + clock.why);
  return out;
}

/// Nothing where the recording has to be loaded.
std::optional<EvaluatedRecording> streamed(const std::filesystem::path& path,
                                           const std::optional<std::filesystem::path>& model_file,
                                           const EvaluationOptions& options, bool read_ahead) {
  auto opened = acquisition::open_recording(path);
  if (!opened || opened->recording.loadcell.t_s.empty()) return std::nullopt;
  const std::optional<Model> model = find_model(opened->recording, model_file);
  if (!estimator::needs_whole(model ? &*model : nullptr, options).empty()) return std::nullopt;
  Recording& recording = opened->recording;
  acquisition::Stream& module = recording.module;
  const bool ends_unknown = module.t_s.empty();
  if (ends_unknown) module.t_s = {-HUGE_VAL, HUGE_VAL};
  ClockMap clock = acquisition::synchronise(recording);
  const estimator::LoadcellSignals loadcell = loadcell_signals(recording, clock);
  module.t_s = std::vector<double>(),
  module.host_s = std::vector<double>();  // = {} keeps the memory
  recording.loadcell.channels.clear();
  const StreamedTelemetry telemetry(*opened->rows, channels_for(*opened->rows, model, options),
                                    read_ahead);
  Evaluation evaluation = estimator::evaluate(telemetry, loadcell, recording.gear_ratio,
                                              model ? &*model : nullptr, options);
  if (ends_unknown) {
    module.t_s = {telemetry.first_s(), telemetry.last_s()};
    clock = acquisition::synchronise(recording);
  }
  return with_notes(std::move(evaluation), recording, clock, true);
}

}  // namespace

EvaluatedRecording evaluate_recording(const std::filesystem::path& path,
                                      const std::optional<std::filesystem::path>& model_file,
                                      const EvaluationOptions& options, bool read_ahead) {
  try {
    if (auto out = streamed(path, model_file, options, read_ahead)) return std::move(*out);
  } catch (const std::exception&) {  // loaded it may do; else that says why not
  }
  const Session session = open_session(path);
  return with_notes(evaluate_session(session, find_model(session.recording, model_file), options),
                    session.recording, session.clock, false);
}

}  // namespace searig::app
