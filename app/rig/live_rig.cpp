#include "app/rig/live_rig.h"

#include "app/rig/believed_model.h"

namespace searig::app {
namespace {

constexpr double synchronise_every_s = 1.0;

}  // namespace

LiveRig::LiveRig(const RigSettings& settings)
    : rig_(settings),
      model_(believed_model(settings.parameters)),
      estimate_(model_, start_from(model_, 1.0)) {
  signals_.gear_ratio = settings.parameters.drive.gear_ratio;
}

void LiveRig::run_until(double host_s) {
  rig_.run_until(host_s);
  take_module();
  take_loadcell(host_s);
  estimate_.follow(signals_);
}

void LiveRig::take_module() {
  const auto& stream = rig_.recording().module;
  const auto& input = stream.channels[0].values;
  const auto& output = stream.channels[1].values;
  auto& module = signals_.module;
  for (std::size_t i = module.t_s.size(); i < stream.t_s.size(); ++i) {
    module.t_s.push_back(stream.t_s[i]);
    module.input_angle_rad.push_back(input[i]);
    module.output_angle_rad.push_back(output[i]);
    module.deflection_rad.push_back(input[i] - output[i]);
    module.current_a.push_back(stream.channels[2].values[i]);
    module.commanded_angle_rad.push_back(stream.channels[3].values[i]);
  }
}

void LiveRig::take_loadcell(double host_s) {
  const auto& recording = rig_.recording();
  const auto& stream = recording.loadcell;
  if (stream.t_s.size() < 10) return;  // too few to say anything about clocks
  auto& loadcell = signals_.loadcell;
  if (host_s >= synchronised_s_ + synchronise_every_s) {
    clock_ = acquisition::synchronise(recording);
    signals_.clock_ci95_s = clock_.ci95_s;
    synchronised_s_ = host_s;
    loadcell.t_s.clear();  // mapped anew with the better map
  }
  for (std::size_t i = loadcell.t_s.size(); i < stream.t_s.size(); ++i) {
    loadcell.t_s.push_back(clock_.to_module(stream.t_s[i]));
  }
  for (std::size_t i = loadcell.torque_nm.size(); i < stream.t_s.size(); ++i) {
    loadcell.torque_nm.push_back(stream.channels[0].values[i] * recording.lever_arm_m);
  }
}

}  // namespace searig::app
