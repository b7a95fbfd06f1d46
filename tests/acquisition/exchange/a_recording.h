// A recording with everything in it that an export has to keep.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "acquisition/exchange/contents.h"
#include "tests/acquisition/clock/simulated_device.h"

namespace searig::acquisition::exchange {

/// Numbers of every size, among them those that print badly.
inline std::vector<double> any_numbers(std::size_t count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> exponent(-300.0, 300.0), sign(-1.0, 1.0);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(std::copysign(std::pow(10.0, exponent(random)), sign(random)));
  const std::vector<double> awkward{0.0, -0.0, 0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308,
                                    1e22};
  for (std::size_t i = 0; i < awkward.size() && i < count; ++i) values[i] = awkward[i];
  return values;
}

/// As in practice: two clocks with host stamps, lost rows, a load cell that restarted, three
/// further devices, pings, events, a model, a calibration, names that are not ASCII.
inline Recording a_recording(double seconds = 20.0) {
  std::mt19937_64 random(7);
  SimulatedDevice module, loadcell;
  module.hz = 500.0;
  module.seconds = loadcell.seconds = seconds;
  module.offset_s = 416.25;
  module.ppm = 30.0;
  loadcell.offset_s = 7.0;
  loadcell.ppm = -2021.0;
  loadcell.lost_share = 0.01;
  Recording recording;
  recording.name =
      "q\xC3\xA4"
      "0,1";
  recording.module = module.run(random, "module");
  recording.loadcell = loadcell.run(random, "loadcell");
  recording.gear_ratio = 349.0;
  recording.lever_arm_m = 0.15;
  for (const char* channel : {"input_angle_rad", "output_angle_rad", "current_a"})
    recording.module.channels.push_back(
        {channel, any_numbers(recording.module.t_s.size(), random)});
  auto& loadcell_s = recording.loadcell.t_s;
  recording.loadcell.channels.push_back({"force_n", any_numbers(loadcell_s.size(), random)});
  recording.loadcell.restarts = {loadcell_s.size() / 3};
  const double back = loadcell_s[loadcell_s.size() / 3] - 1.0;
  for (std::size_t i = loadcell_s.size() / 3; i < loadcell_s.size(); ++i) loadcell_s[i] -= back;
  recording.loadcell.counts = {loadcell_s.size(), 10, 1, 2, 3};
  recording.module.counts.received = recording.module.t_s.size();
  recording.loadcell.host_latency = HostLatency{0.002, 1e-4};
  recording.loadcell.least_wire_s = 0.0013;
  for (int i = 0; i < 5; ++i)
    recording.loadcell.pings.push_back(
        {i + 0.1, i + 0.2, i + 1.0 / 3.0, i + 0.4, std::size_t(i > 2)});
  for (const AlignedBy how : {AlignedBy::host, AlignedBy::clock}) {
    SimulatedDevice device;
    device.hz = 30.0;
    device.seconds = seconds;
    device.offset_s = how == AlignedBy::clock ? 416.25 : -1e4;
    Device further{device.run(random, how == AlignedBy::clock ? "device.a-b" : "device.a.b"), how};
    further.stream.counts.received = further.stream.t_s.size();
    further.stream.channels.push_back(
        {how == AlignedBy::clock ? "motor_angle_rad" : "spring_temperature_c",
         any_numbers(further.stream.t_s.size(), random)});
    recording.devices.push_back(std::move(further));
  }
  recording.events = {{1.5, "loadcell", "restart", "It began \"anew\",\nat once."}};
  recording.model_toml = "format = \"searig-model/1\"\n# \xCE\xB8\n";
  recording.calibration = "# by hand\n[loadcell]\n";
  recording.recorded = "Recorded by hand.";
  return recording;
}

inline Contents contents_of(const Recording& recording) {
  std::vector<ClockMap> devices;
  for (const Device& device : recording.devices) devices.push_back(synchronise(recording, device));
  return contents_of(recording, synchronise(recording), devices);
}

}  // namespace searig::acquisition::exchange
