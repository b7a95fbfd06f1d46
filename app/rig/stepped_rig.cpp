#include "app/rig/stepped_rig.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "acquisition/recorder/wall_clock.h"
#include "acquisition/source/decode.h"
#include "acquisition/wire/encode.h"
#include "app/rig/believed_model.h"

namespace searig::app {
namespace {

using acquisition::Arrival;
using acquisition::StreamId;

// us of the devices' time. Each step is as long as chance has it, as a thread wakes: arrivals at
// even steps would beat with the devices' own.
constexpr long shortest_step = 200, longest_step = 1600;
constexpr long look_every = 20'000;    // the estimate follows
constexpr long write_every = 100'000;  // what has come is written, as one chunk
constexpr long ping_every = 500'000;
constexpr long tell_every = 1'000'000;  // counters, clocks

}  // namespace

SteppedRig::Device SteppedRig::make(StreamId id, SimulatedDevice device) const {
  auto source = id == StreamId::module ? open_module(device) : open_board(device);
  const auto framing = acquisition::framing_of(source->name());
  source->send(acquisition::identify_frame());
  return {std::move(device), std::move(source), acquisition::DeviceStream(id, framing)};
}

SteppedRig::SteppedRig(const std::filesystem::path& file, const std::string& program,
                       const DeviceOptions& options)
    : options_(options),
      module_(make(StreamId::module, start_module(options, true, 0.0))),
      loadcell_(make(StreamId::loadcell, start_board(options, true, 0.0))),
      file_(file),
      out_([this](std::string_view bytes) { file_.append(bytes); }, program,
           acquisition::unix_now_s()),
      twin_({}, options.seed),
      model_(believed_model(twin_.parameters())),
      signals_(twin_.parameters().lever.arm_m),
      estimate_(model_, start_from(model_, 1.0)) {
  settings_.program = program;
  settings_.started = acquisition::utc(acquisition::unix_now_s());
  settings_.lever_arm_m = twin_.parameters().lever.arm_m;
  settings_.model_toml = estimator::to_toml(model_);
  settings_.module.source = "sim:" + module_.source->name();
  settings_.loadcell.source = "sim:" + loadcell_.source->name();
  settings_.loadcell.baud = loadcell_.source->baud();
  entries_.push_back(acquisition::NewSettings{0.0, settings_});
  follow();
  out_.file().end_chunk();  // so that the file says from the beginning whose it is
}

void SteppedRig::run_until(double seconds) {
  const long until_us = std::lround(1e6 * seconds);
  while (now_us_ < until_us) {
    std::uniform_int_distribution<long> length(shortest_step, longest_step);
    step(std::min(until_us, now_us_ + length(random_)));
  }
}

/// Both devices simulate it at the same time, each on a processor of its own.
void SteppedRig::step(long until_us) {
  const auto due = [&](long every_us) { return now_us_ / every_us != until_us / every_us; };
  if (due(ping_every))
    for (Device* device : {&module_, &loadcell_})
      device->source->send(acquisition::ping_frame(device->pings++, now_s()));
  const bool tells = due(tell_every), follows = due(look_every), writes = due(write_every);
  now_us_ = until_us;
  for (Device* device : {&module_, &loadcell_})
    device->device.process->say("run " + std::to_string(now_s()));
  for (Device* device : {&module_, &loadcell_})
    if (device->device.process->hear() != "ok")
      throw std::runtime_error("The simulated device " + device->device.address + " has ended.");
  hear(module_);
  hear(loadcell_);
  if (tells) tell();
  if (follows) follow();
  if (writes) out_.file().end_chunk();
}

/// What a device has said by now. That a source finds it silent for long, or back, is about the
/// time which this machine takes, and not about the device.
void SteppedRig::hear(Device& device) {
  arrivals_.clear();
  device.source->read(arrivals_);
  for (Arrival& arrival : arrivals_) {
    if (arrival.kind != Arrival::Kind::bytes && arrival.kind != Arrival::Kind::connected) continue;
    arrival.host_s = now_s();
    device.stream.take(arrival, entries_);
  }
}

/// Each second: the counters, the clocks; and once, who the devices are.
void SteppedRig::tell() {
  for (Device* device : {&module_, &loadcell_})
    device->stream.tell(now_s(), device->source->counters(), entries_);
  const auto known = [](const Device& device, acquisition::mcap::StreamSettings& settings) {
    const auto& identity = device.stream.identity();
    if (!identity) return false;
    const std::string words = words_of(*identity);
    return std::exchange(settings.device, words) != words;
  };
  const bool module = known(module_, settings_.module);
  if (known(loadcell_, settings_.loadcell) || module) {
    if (const auto& who = module_.stream.identity()) settings_.gear_ratio = who->gear_ratio;
    entries_.push_back(acquisition::NewSettings{now_s(), settings_});
  }
  if (const auto map = clock_.estimate()) {
    out_.clock(now_s(), *map);
    signals_.place(*map);
  }
}

void SteppedRig::follow() {
  for (const acquisition::Entry& entry : entries_) {
    write_entry(entry, out_);
    clock_.take(entry);
  }
  signals_.take(entries_);
  estimate_.follow(signals_.signals());
  entries_.clear();
}

void SteppedRig::finish() {
  tell();
  follow();
  out_.file().finish();
  file_.sync();
}

acquisition::ClockMap SteppedRig::true_clock_map() const {
  const DeviceClock module = options_.module_clock(), board = options_.board_clock();
  acquisition::ClockMap map;
  map.rate = (1.0 + module.rate_error_ppm * 1e-6) / (1.0 + board.rate_error_ppm * 1e-6);
  map.offset_s = module.offset_s - map.rate * board.offset_s;
  map.why = "the simulated devices' own clocks";
  return map;
}

double SteppedRig::true_stiffness_nm_per_rad() {
  twin_.advance_to(now_s());
  return twin_.stiffness_nm_per_rad();
}

}  // namespace searig::app
