#include "acquisition/exchange/contents.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "acquisition/exchange/facts.h"
#include "acquisition/exchange/table.h"
#include "acquisition/recording/text_file.h"
#include "acquisition/recording/units.h"

namespace searig::acquisition::exchange {
namespace {

Group stream_group(Contents& contents, const Stream& stream, const std::vector<RunMap>& runs) {
  Group group{stream.name, "Every row of " + stream.name + " as it was received.", {}};
  const auto add = [&](std::string name, std::string how, std::span<const double> values) {
    std::string unit(unit_of(name));
    group.columns.push_back({std::move(name), std::move(unit), std::move(how), values});
  };
  add("t_s", "on the module's clock; not a number where a restart left no way to it",
      contents.keep(on_module_clock(stream, runs)));
  add("device_t_s", "on the stream's own clock, as received", stream.t_s);
  if (!stream.host_s.empty())
    add("host_s", "on the host's clock at arrival, as received", stream.host_s);
  for (const Channel& channel : stream.channels) add(channel.name, "as received", channel.values);
  return group;
}

Group ping_group(Contents& contents, const Stream& stream) {
  Group group{
      stream.name + ".pings", "Two-way exchanges with the device of " + stream.name + ".", {}};
  const auto add = [&](const char* name, const char* how, auto member) {
    std::vector<double> values;
    for (const Exchange& ping : stream.pings) values.push_back(double(ping.*member));
    group.columns.push_back(
        {name, std::string(unit_of(name)), how, contents.keep(std::move(values))});
  };
  add("host_sent_s", "on the host's clock", &Exchange::host_sent_s);
  add("device_received_s", "on the device's clock", &Exchange::device_received_s);
  add("device_sent_s", "on the device's clock", &Exchange::device_sent_s);
  add("host_received_s", "on the host's clock", &Exchange::host_received_s);
  add("run", "of the device, from 0", &Exchange::run);
  return group;
}

std::string clock_sentence(const std::string& whose, const ClockMap& clock) {
  std::string words = "module time = ";
  append_number(words, clock.rate);
  words += " * " + whose + " time + ";
  append_number(words, clock.offset_s);
  words += " s; 95 % interval +-";
  append_number(words, clock.ci95_s);
  words += " s at the middle of the recording; ";
  // Restarts, or a clock that runs unevenly.
  if (clock.loadcell_runs.size() > 1)
    words +=
        std::to_string(clock.loadcell_runs.size()) + " pieces, each placed by a map of its own; ";
  return words + (clock.trusted ? "trusted: " : "NOT TRUSTED: ") + clock.why;
}

}  // namespace

const Column* Group::find(std::string_view column) const {
  const auto found = std::ranges::find(columns, column, &Column::name);
  return found == columns.end() ? nullptr : &*found;
}

std::span<const double> Contents::keep(std::vector<double> values) {
  made.push_back(std::move(values));
  return made.back();
}

Contents contents_of(const Recording& recording, const ClockMap& clock,
                     const std::vector<ClockMap>& devices) {
  Contents contents;
  contents.name = recording.name;
  contents.groups.push_back(stream_group(contents, recording.module, clock.module_runs));
  contents.groups.push_back(stream_group(contents, recording.loadcell, clock.loadcell_runs));
  for (std::size_t i = 0; i < devices.size(); ++i)
    contents.groups.push_back(
        stream_group(contents, recording.devices[i].stream, devices[i].loadcell_runs));
  contents.clocks.push_back(clock_sentence("loadcell", clock));
  for (std::size_t i = 0; i < devices.size(); ++i)
    contents.clocks.push_back(clock_sentence(recording.devices[i].stream.name, devices[i]));
  const auto pings = [&](const Stream& stream) {
    if (!stream.pings.empty()) contents.groups.push_back(ping_group(contents, stream));
  };
  pings(recording.module);
  pings(recording.loadcell);
  for (const Device& device : recording.devices) pings(device.stream);
  contents.table = table_of(contents, recording, clock, devices);
  contents.facts = facts_of(recording, clock, devices, contents.groups);
  return contents;
}

std::vector<std::string> identifiers(const std::vector<std::string>& names) {
  std::vector<std::string> out;
  for (const std::string& name : names) {
    std::string id = std::isalpha(static_cast<unsigned char>(name[0])) ? "" : "x";
    for (const char c : name.substr(0, 55))
      id += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    const std::string stem = id;
    for (int i = 2; std::ranges::find(out, id) != out.end(); ++i)
      id = stem + "_" + std::to_string(i);
    out.push_back(id);
  }
  return out;
}

}  // namespace searig::acquisition::exchange
