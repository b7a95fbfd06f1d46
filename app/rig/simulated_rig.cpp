#include "app/rig/simulated_rig.h"

#include <algorithm>
#include <initializer_list>

namespace searig::app {
namespace {

using acquisition::Stream;

Stream make_stream(const char* name, std::initializer_list<const char*> channels) {
  Stream stream;
  stream.name = name;
  for (const char* channel : channels) stream.channels.push_back({channel, {}});
  return stream;
}

}  // namespace

SimulatedRig::SimulatedRig(const RigSettings& settings)
    : settings_(settings),
      twin_(settings.parameters, settings.seed),
      module_link_(settings.module, settings.seed + 300),
      loadcell_link_(settings.loadcell, settings.seed + 400) {
  recording_.name = "simulated rig";
  recording_.gear_ratio = settings.parameters.drive.gear_ratio;
  recording_.lever_arm_m = settings.parameters.lever.arm_m;
  recording_.module = make_stream(
      "module", {"input_angle_rad", "output_angle_rad", "current_a", "commanded_angle_rad"});
  recording_.loadcell = make_stream("loadcell", {"force_n"});
}

void SimulatedRig::run_until(double host_s) {
  // Readings are taken in the order of true time, as the twin cannot go back, and then wait until
  // they arrive.
  for (;;) {
    const double module_s = module_link_.next().taken_s;
    const double loadcell_s = loadcell_link_.next().taken_s;
    if (std::min(module_s, loadcell_s) > host_s) break;
    if (module_s <= loadcell_s) {
      take_module_sample();
    } else {
      take_loadcell_sample();
    }
  }
  deliver(module_on_the_way_, host_s, recording_.module);
  deliver(loadcell_on_the_way_, host_s, recording_.loadcell);
}

void SimulatedRig::take_module_sample() {
  twin_.advance_to(module_link_.next().taken_s);
  const auto reading = twin_.read_module();
  module_on_the_way_.push_back({module_link_.next(),
                                {reading.input_angle_rad, reading.output_angle_rad,
                                 reading.current_a, reading.commanded_angle_rad}});
  module_link_.advance();
}

void SimulatedRig::take_loadcell_sample() {
  twin_.advance_to(loadcell_link_.next().taken_s);
  loadcell_on_the_way_.push_back({loadcell_link_.next(), {twin_.read_loadcell().force_n}});
  loadcell_link_.advance();
}

void SimulatedRig::deliver(std::deque<Sample>& on_the_way, double host_s, Stream& stream) {
  for (; !on_the_way.empty() && on_the_way.front().passage.arrival_s <= host_s;
       on_the_way.pop_front()) {
    const auto& [passage, values] = on_the_way.front();
    if (passage.lost) {
      ++stream.counts.lost;
      continue;
    }
    ++stream.counts.received;
    stream.t_s.push_back(passage.device_s);
    stream.host_s.push_back(passage.arrival_s);
    for (std::size_t i = 0; i < values.size(); ++i) {
      stream.channels[i].values.push_back(values[i]);
    }
  }
}

acquisition::ClockMap SimulatedRig::true_clock_map() const {
  const auto& module = settings_.module.clock;
  const auto& loadcell = settings_.loadcell.clock;
  acquisition::ClockMap map;
  map.rate = (1.0 + module.rate_error_ppm * 1e-6) / (1.0 + loadcell.rate_error_ppm * 1e-6);
  map.offset_s = module.offset_s - map.rate * loadcell.offset_s;
  map.why = "the simulated rig's own clocks";
  return map;
}

}  // namespace searig::app
