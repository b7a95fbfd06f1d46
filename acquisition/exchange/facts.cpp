#include "acquisition/exchange/facts.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/recording/mcap/settings.h"

namespace searig::acquisition::exchange {
namespace {

using nlohmann::json;

json counts_json(const StreamCounts& counts) {
  return {{"received", counts.received},
          {"lost", counts.lost},
          {"doubled", counts.doubled},
          {"garbled", counts.garbled},
          {"out_of_order", counts.out_of_order}};
}

json clock_json(const ClockMap& clock, const std::vector<RunMap>& runs) {
  json out{{"rate", clock.rate},       {"offset_s", clock.offset_s}, {"ci95_s", clock.ci95_s},
           {"trusted", clock.trusted}, {"why", clock.why},           {"runs", json::array()}};
  for (const RunMap& run : runs)
    out["runs"].push_back(
        {{"first", run.first}, {"last", run.last}, {"rate", run.rate}, {"offset_s", run.offset_s}});
  return out;
}

json stream_json(const Stream& stream) {
  json out{{"name", stream.name},
           {"counts", counts_json(stream.counts)},
           {"restarts", stream.restarts},
           {"least_wire_s", stream.least_wire_s}};
  if (stream.host_latency)
    out["host_latency"] = {{"latency_s", stream.host_latency->latency_s},
                           {"ci95_s", stream.host_latency->ci95_s}};
  return out;
}

json groups_json(const std::vector<Group>& groups) {
  json out = json::array();
  for (const Group& group : groups) {
    out.push_back({{"name", group.name}, {"rows", group.rows()}, {"columns", json::array()}});
    for (const Column& column : group.columns) out.back()["columns"].push_back(column.name);
  }
  return out;
}

json events_json(const std::vector<Event>& events) {
  json out = json::array();
  for (const Event& event : events)
    out.push_back({{"host_s", event.host_s},
                   {"device", event.device},
                   {"kind", event.kind},
                   {"text", event.text}});
  return out;
}

/// What is asked of facts that are JSON, but perhaps not these.
template <typename Work>
auto reading(std::string_view text, Work work) {
  try {
    const json facts = json::parse(text);
    if (facts.at("format") != facts_format)
      throw InputError("was written as " + facts["format"].dump() + ", which is not known here.");
    return work(facts);
  } catch (const json::exception& error) {
    throw InputError(std::string("holds facts that cannot be read: ") + error.what() + ".");
  }
}

/// The stream's facts and its columns put together again.
Stream stream_of(const json& facts, std::vector<ReadGroup>& groups) {
  Stream stream;
  stream.name = facts.at("name");
  const json& counts = facts.at("counts");
  stream.counts = {counts.at("received"), counts.at("lost"), counts.at("doubled"),
                   counts.at("garbled"), counts.at("out_of_order")};
  stream.restarts = facts.at("restarts").get<std::vector<std::size_t>>();
  stream.least_wire_s = facts.at("least_wire_s");
  if (facts.contains("host_latency"))
    stream.host_latency = {facts["host_latency"].at("latency_s"),
                           facts["host_latency"].at("ci95_s")};
  const auto group = std::ranges::find(groups, stream.name, &ReadGroup::name);
  if (group == groups.end()) throw InputError("has no columns of " + stream.name + ".");
  for (const std::size_t restart : stream.restarts)
    if (restart >= group->rows) throw InputError("tells of a restart behind the last row.");
  for (Channel& column : group->columns) {
    if (column.name == "t_s") continue;  // follows from the clocks
    if (column.name == "device_t_s")
      stream.t_s = std::move(column.values);
    else if (column.name == "host_s")
      stream.host_s = std::move(column.values);
    else
      stream.channels.push_back(std::move(column));
  }
  if (stream.t_s.size() != group->rows)
    throw InputError("has no device_t_s of " + stream.name + ".");
  return stream;
}

void add_pings(Stream& stream, const std::vector<ReadGroup>& groups) {
  const auto group = std::ranges::find(groups, stream.name + ".pings", &ReadGroup::name);
  if (group == groups.end()) return;
  const auto column = [&](const char* name) -> const std::vector<double>& {
    if (const std::vector<double>* values = group->find(name)) return *values;
    throw InputError("has no " + std::string(name) + " of " + group->name + ".");
  };
  const auto &sent = column("host_sent_s"), &received = column("host_received_s"),
             &device_received = column("device_received_s"), &device_sent = column("device_sent_s"),
             &run = column("run");
  for (std::size_t i = 0; i < group->rows; ++i)
    stream.pings.push_back({sent[i], device_received[i], device_sent[i], received[i],
                            static_cast<std::size_t>(std::max(0.0, run[i]))});
}

Recording recording_from(const json& facts, std::vector<ReadGroup>& groups) {
  Recording recording;
  recording.name = facts.at("name");
  recording.gear_ratio = facts.at("gear_ratio");
  recording.lever_arm_m = facts.at("lever_arm_m");
  recording.one_clock = facts.at("one_clock");
  recording.model_toml = facts.at("model_toml");
  recording.calibration = facts.at("calibration");
  recording.recorded = facts.at("recorded");
  for (const json& event : facts.at("events"))
    recording.events.push_back(
        {event.at("host_s"), event.at("device"), event.at("kind"), event.at("text")});
  for (const json& each : facts.at("streams")) {
    Stream stream = stream_of(each, groups);
    add_pings(stream, groups);
    if (stream.name == "module")
      recording.module = std::move(stream);
    else if (stream.name == "loadcell")
      recording.loadcell = std::move(stream);
    else
      recording.devices.push_back(
          {std::move(stream), mcap::aligned_by(each.at("aligned_by").get<std::string>())});
  }
  if (recording.module.t_s.empty()) throw InputError("holds no samples of the module.");
  return recording;
}

}  // namespace

std::string facts_of(const Recording& recording, const ClockMap& clock,
                     const std::vector<ClockMap>& devices, const std::vector<Group>& groups) {
  json streams{stream_json(recording.module), stream_json(recording.loadcell)};
  streams[0]["to_module"] = clock_json({}, clock.module_runs);
  streams[1]["to_module"] = clock_json(clock, clock.loadcell_runs);
  for (std::size_t i = 0; i < devices.size(); ++i) {
    streams.push_back(stream_json(recording.devices[i].stream));
    streams.back()["aligned_by"] = mcap::name_of(recording.devices[i].aligned_by);
    streams.back()["to_module"] = clock_json(devices[i], devices[i].loadcell_runs);
  }
  const json facts{{"format", facts_format},
                   {"name", recording.name},
                   {"gear_ratio", recording.gear_ratio},
                   {"lever_arm_m", recording.lever_arm_m},
                   {"one_clock", recording.one_clock},
                   {"model_toml", recording.model_toml},
                   {"calibration", recording.calibration},
                   {"recorded", recording.recorded},
                   {"cut_off", recording.cut_off},
                   {"events", events_json(recording.events)},
                   {"streams", streams},
                   {"groups", groups_json(groups)}};
  return facts.dump(-1, ' ', true, json::error_handler_t::replace);
}

const std::vector<double>* ReadGroup::find(std::string_view column) const {
  const auto found = std::ranges::find(columns, column, &Channel::name);
  return found == columns.end() ? nullptr : &found->values;
}

std::vector<ReadGroup> groups_of(std::string_view facts) {
  return reading(facts, [](const json& in) {
    std::vector<ReadGroup> groups;
    for (const json& group : in.at("groups")) {
      groups.push_back({group.at("name"), group.at("rows"), {}});
      for (const json& column : group.at("columns")) groups.back().columns.push_back({column, {}});
    }
    return groups;
  });
}

Recording recording_of(std::string_view facts, std::vector<ReadGroup> groups) {
  return reading(facts, [&](const json& in) { return recording_from(in, groups); });
}

}  // namespace searig::acquisition::exchange
