#include "acquisition/recording/mcap/settings.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/recording/mcap/layout.h"

namespace searig::acquisition::mcap {
namespace {

using nlohmann::json;

json stream_json(const StreamSettings& stream) {
  json out = {{"source", stream.source}, {"device", stream.device}};
  if (stream.baud != 0) out["baud"] = stream.baud;
  if (stream.host_latency)
    out["host_latency"] = {{"latency_s", stream.host_latency->latency_s},
                           {"ci95_s", stream.host_latency->ci95_s}};
  if (stream.sorted) {
    const StreamCounts& counts = stream.sorted->counts;
    out["sorted"] = {{"received", counts.received},
                     {"lost", counts.lost},
                     {"doubled", counts.doubled},
                     {"garbled", counts.garbled},
                     {"out_of_order", counts.out_of_order},
                     {"restarts", stream.sorted->restarts},
                     {"least_wire_s", stream.sorted->least_wire_s}};
  }
  return out;
}

StreamSettings stream_settings(const json& in) {
  StreamSettings stream;
  stream.source = in.at("source");
  stream.device = in.at("device");
  stream.baud = in.value("baud", 0u);
  if (in.contains("host_latency"))
    stream.host_latency = {in["host_latency"].at("latency_s"), in["host_latency"].at("ci95_s")};
  if (in.contains("sorted")) {
    const json& sorted = in["sorted"];
    stream.sorted = {{sorted.at("received"), sorted.at("lost"), sorted.at("doubled"),
                      sorted.at("garbled"), sorted.at("out_of_order")},
                     sorted.at("restarts"),
                     sorted.value("least_wire_s", 0.0)};
  }
  return stream;
}

constexpr std::array<std::pair<AlignedBy, const char*>, 3> alignments{
    {{AlignedBy::host, "host"}, {AlignedBy::clock, "clock"}, {AlignedBy::velocity, "velocity"}}};

json device_json(const DeviceSettings& device) {
  json out = stream_json(device.stream);
  out["name"] = device.name;
  out["aligned_by"] = name_of(device.aligned_by);
  return out;
}

DeviceSettings device_settings(const json& in) {
  return {in.at("name"), aligned_by(in.at("aligned_by").get<std::string>()), stream_settings(in)};
}

}  // namespace

const char* name_of(AlignedBy how) {
  return std::ranges::find(alignments, how, &decltype(alignments)::value_type::first)->second;
}

AlignedBy aligned_by(std::string_view name) {
  for (const auto& [how, its_name] : alignments)
    if (name == its_name) return how;
  throw InputError("aligns a device by '" + std::string(name) + "', which is not known.");
}

std::string to_json(const Settings& settings) {
  json out = {{"format", format_name},
              {"program", settings.program},
              {"started", settings.started},
              {"gear_ratio", settings.gear_ratio},
              {"lever_arm_m", settings.lever_arm_m},
              {"one_clock", settings.one_clock},
              {"module", stream_json(settings.module)},
              {"loadcell", stream_json(settings.loadcell)},
              {"model_toml", settings.model_toml},
              {"calibration", settings.calibration}};
  for (const DeviceSettings& device : settings.devices)
    out["devices"].push_back(device_json(device));
  if (!settings.recorded.empty()) out["recorded"] = settings.recorded;
  // A file name may hold any bytes; one that is not UTF-8 must not keep a recording from starting.
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

Settings settings_from_json(std::string_view text) {
  try {
    const json in = json::parse(text);
    if (in.at("format") != format_name)
      throw InputError("was written as " + in["format"].dump() +
                       ", which this program is too old " + "to read.");
    Settings settings;
    settings.program = in.at("program");
    settings.started = in.at("started");
    settings.gear_ratio = in.at("gear_ratio");
    settings.lever_arm_m = in.at("lever_arm_m");
    settings.one_clock = in.at("one_clock");
    settings.module = stream_settings(in.at("module"));
    settings.loadcell = stream_settings(in.at("loadcell"));
    settings.model_toml = in.at("model_toml");
    settings.calibration = in.at("calibration");
    for (const json& device : in.value("devices", json::array()))
      settings.devices.push_back(device_settings(device));
    settings.recorded = in.value("recorded", "");
    return settings;
  } catch (const json::exception& error) {
    throw InputError(std::string("holds settings that cannot be read: ") + error.what() + ".");
  }
}

}  // namespace searig::acquisition::mcap
