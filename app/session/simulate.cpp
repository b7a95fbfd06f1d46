#include "app/session/simulate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "acquisition/clock/placed_rows.h"
#include "app/session/device_channels.h"
#include "estimator/model/predict.h"

namespace searig::app {
namespace {

using acquisition::PlacedRows;
using acquisition::Stream;

/// Normal numbers that are the same on every machine; the standard library's are not.
class Normal {
 public:
  explicit Normal(std::uint64_t seed) : bits_(seed) {}

  double operator()() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  double uniform() { return (double(bits_() >> 11) + 0.5) * 0x1p-53; }

  std::mt19937_64 bits_;
};

void add_noise(std::vector<double>& values, double sd, std::uint64_t seed) {
  if (sd <= 0.0) return;
  Normal normal(seed);
  for (double& value : values) value += sd * normal();
}

Stream rows_of(const Stream& stream, const PlacedRows& placed) {
  Stream out = stream;
  out.t_s = acquisition::at_rows(stream.t_s, placed);
  out.host_s = acquisition::at_rows(stream.host_s, placed);
  for (auto& channel : out.channels) channel.values = acquisition::at_rows(channel.values, placed);
  out.restarts.clear();
  return out;
}

void set_channel(Stream& stream, const std::string& name, std::vector<double> values) {
  const auto it = std::ranges::find(stream.channels, name, &acquisition::Channel::name);
  if (it != stream.channels.end()) {
    it->values = std::move(values);
  } else {
    stream.channels.push_back({name, std::move(values)});
  }
}

void drop_channel(Stream& stream, const std::string& name) {
  std::erase_if(stream.channels, [&](const auto& channel) { return channel.name == name; });
}

}  // namespace

Simulated simulate(const estimator::Model& model, const Session& like,
                   const SimulatedNoise& noise) {
  const auto& signals = like.signals;
  const auto torques = estimator::predict(model, signals.module);
  if (torques.loadcell_nm.empty()) {
    throw std::invalid_argument(like.recording.name +
                                " has no deflection to simulate a spring with");
  }
  Simulated out{like.recording, {}};
  out.recording.module = rows_of(like.recording.module, like.module_rows);
  for (auto& channel : device_channels(like.recording, like.devices, like.module_rows))
    set_channel(out.recording.module, channel.name, std::move(channel.values));
  out.recording.devices.clear();
  out.recording.loadcell =
      rows_of(like.recording.loadcell,
              acquisition::place_rows(like.recording.loadcell, like.clock.loadcell_runs));

  auto measured =
      estimator::sample_at(signals.module.t_s, torques.loadcell_nm, signals.loadcell.t_s);
  add_noise(measured, noise.loadcell_nm, noise.seed);
  drop_channel(out.recording.loadcell, "force_n");
  set_channel(out.recording.loadcell, "torque_nm", std::move(measured));

  auto current = model.has("drive.motor")
                     ? estimator::current_for(model, signals.module, torques.spring_nm)
                     : std::vector<double>();
  if (current.empty()) {
    out.notes.push_back(model.has("drive.motor")
                            ? "there is no current: the recording has no input angle or velocity"
                            : "there is no current: the model has no drive.motor");
    drop_channel(out.recording.module, "current_a");
    return out;
  }
  add_noise(current, noise.current_a, noise.seed + 1);
  set_channel(out.recording.module, "current_a", std::move(current));
  return out;
}

}  // namespace searig::app
