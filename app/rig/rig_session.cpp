#include "app/rig/rig_session.h"

#include <stdexcept>
#include <utility>

#include "acquisition/calibration/loadcell_calibration.h"
#include "acquisition/recorder/wall_clock.h"
#include "app/rig/believed_model.h"
#include "estimator/twin/parameters.h"

namespace searig::app {
namespace {

bool obeys(acquisition::ChildProcess* process, const std::string& command) {
  if (process == nullptr) return false;
  process->say(command);
  return process->hear() == "ok";
}

/// What was not said and yet is known.
RigOptions completed(RigOptions options) {
  if (!options.calibration.empty() && !options.lever_arm_m)
    options.lever_arm_m =
        acquisition::parse_calibration(options.calibration, "the calibration").lever_arm_m;
  if (options.loadcell == simulated && !options.lever_arm_m)
    options.lever_arm_m = estimator::twin::LeverParameters{}.arm_m;
  if (options.module == simulated && !options.model)
    options.model = believed_model(estimator::twin::Parameters{});
  return options;
}

}  // namespace

RigSession::RigSession(RigOptions options) : options_(completed(std::move(options))) {
  if (!options_.calibration.empty()) {
    const auto calibration =
        acquisition::parse_calibration(options_.calibration, "the calibration");
    counts_to_force_ = {calibration.tare_counts, calibration.newton_per_count};
  }
  SimulatedSources rig = open_rig(options_.module, options_.loadcell, options_.simulation);
  module_process_ = rig.module_process;
  board_process_ = rig.board_process;
  lines_ = std::make_shared<acquisition::Lines>(std::move(rig.module), std::move(rig.loadcell));
  feed_ = std::make_unique<LiveFeed>(
      lines_, FollowOptions{options_.lever_arm_m.value_or(1.0), counts_to_force_, options_.model});
  lines_->start();
}

RigSession::~RigSession() {
  end_recording();
  feed_.reset();
  lines_->stop();
}

acquisition::RecorderOptions RigSession::recorder_options(const std::filesystem::path& file,
                                                          const std::string& notes) const {
  acquisition::RecorderOptions out;
  out.file.path = file;
  out.file.program = options_.program;
  out.file.epoch_s = acquisition::unix_now_s() - acquisition::host_now_s();
  out.started = acquisition::utc(acquisition::unix_now_s());
  out.lever_arm_m = options_.lever_arm_m;
  out.loadcell = counts_to_force_;
  out.calibration = options_.calibration;
  if (options_.model) out.model_toml = estimator::to_toml(*options_.model);
  out.notes = notes;
  return out;
}

void RigSession::start_recording(const std::filesystem::path& file, const std::string& notes) {
  if (recording().running)
    throw std::runtime_error("One recording at a time: " + recording().file.string() + " runs.");
  end_recording();
  recorder_ = std::make_unique<acquisition::Recorder>(recorder_options(file, notes), lines_);
  stop_ = false;
  status_ = {true, file, 0.0, 0, acquisition::free_bytes_beside(file), {}};
  recording_ = std::thread([this] {
    const auto tell = [this](const acquisition::RecorderState& state) {
      const std::lock_guard lock(mutex_);
      status_.seconds = state.seconds;
      status_.bytes = state.bytes_written;
      status_.free_bytes = acquisition::free_bytes_beside(status_.file);
    };
    std::string failure;
    try {
      tell(recorder_->run(stop_, tell));
    } catch (const std::exception& error) {
      failure = error.what();
    }
    const std::lock_guard lock(mutex_);
    status_.running = false;
    status_.failure = failure;
  });
}

void RigSession::end_recording() {
  stop_ = true;
  if (recording_.joinable()) recording_.join();
  recorder_.reset();
}

RecordingStatus RigSession::recording() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void RigSession::mark(const std::string& words) {
  if (recording().running) recorder_->mark("marker", words);
}

bool RigSession::command_board(const std::string& command) {
  return obeys(board_process_.get(), command);
}

bool RigSession::command_module(const std::string& command) {
  return obeys(module_process_.get(), command);
}

}  // namespace searig::app
