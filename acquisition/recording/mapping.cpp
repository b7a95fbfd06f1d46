#include "acquisition/recording/mapping.h"

#include <algorithm>
#include <cmath>

#include "acquisition/error.h"
#include "acquisition/recording/toml_section.h"
#include "acquisition/recording/units.h"

namespace searig::acquisition {
namespace {

ColumnMapping column_mapping(const Section& columns, std::string_view channel) {
  if (const toml::node* plain = columns.table().get(channel); !plain->is_table())
    columns.refuse(plain, columns.key(channel) + " must be a table such as { column = \"name\" }");
  const Section entry = columns.section(channel);
  const auto si_unit = channel_unit(channel);
  if (!si_unit) entry.refuse(&entry.table(), entry.name() + ": there is no such channel");

  ColumnMapping mapping;
  mapping.channel = channel;
  const toml::node* column = entry.table().get("column");
  if (!column) entry.refuse(&entry.table(), entry.name() + ".column is missing");
  if (const auto number = column->value_exact<int64_t>(); number && *number >= 0)
    mapping.column = static_cast<std::size_t>(*number);
  else if (const auto name = column->value_exact<std::string>())
    mapping.column = *name;
  else
    entry.refuse(column, entry.name() + ".column must be a column's name, or its number from 0");

  mapping.scale = entry.nonzero("scale").value_or(1.0);
  mapping.wraps_at = entry.positive("wraps_at");
  if (const auto name = entry.text("unit")) {
    const auto unit = find_unit(*name);
    if (!unit || unit->measures != *si_unit)
      entry.refuse(entry.table().get("unit"),
                   entry.name() + ".unit '" + *name + "' is none of " + units_like(*si_unit));
    mapping.offset = mapping.scale * unit->to_si.offset;
    mapping.scale *= unit->to_si.factor;
  }
  return mapping;
}

StreamMapping stream_mapping(const Section& section) {
  StreamMapping stream;
  stream.name = section.name();
  const auto file = section.text("file");
  if (!file) section.refuse(nullptr, section.key("file") + " is missing");
  stream.file = section.file().parent_path() / *file;

  if (const auto latency = section.number("host_latency_s"))
    stream.host_latency = {*latency, std::abs(section.number("host_latency_ci95_s").value_or(0.0))};

  stream.native = !section.table().contains("columns");
  if (!stream.native) {
    const Section columns = section.section("columns");
    for (const auto& [channel, entry] : columns.table())
      stream.columns.push_back(column_mapping(columns, channel.str()));
    if (const std::string missing = missing_channel(stream, stream.columns); !missing.empty())
      columns.refuse(&columns.table(), columns.name() + " lacks " + missing);
  }
  stream.faults = stream.native ? Faults::refuse : Faults::count;
  if (const auto faults = section.text("faults")) {
    if (*faults != "count" && *faults != "refuse")
      section.refuse(section.table().get("faults"),
                     section.key("faults") + " must be \"count\" or \"refuse\"");
    stream.faults = *faults == "count" ? Faults::count : Faults::refuse;
  }
  return stream;
}

AlignedBy aligned_by(const Section& section) {
  const std::string how = section.text("aligned_by").value_or("host");
  if (how == "host") return AlignedBy::host;
  if (how == "clock") return AlignedBy::clock;
  if (how == "velocity") return AlignedBy::velocity;
  section.refuse(section.table().get("aligned_by"),
                 section.key("aligned_by") + " must be \"host\", \"clock\" or \"velocity\"");
}

/// [device.a], [device.b] ... in the order of their names.
std::vector<DeviceMapping> device_mappings(const Section& root) {
  std::vector<DeviceMapping> devices;
  if (!root.table().contains("device")) return devices;
  const Section all = root.section("device");
  for (const auto& [name, entry] : all.table()) {
    const Section section = all.section(name.str());
    devices.push_back({stream_mapping(section), aligned_by(section)});
  }
  return devices;
}

}  // namespace

std::string missing_channel(const StreamMapping& stream,
                            const std::vector<ColumnMapping>& columns) {
  const auto has = [&](std::string_view channel) {
    return std::any_of(columns.begin(), columns.end(),
                       [&](const ColumnMapping& c) { return c.channel == channel; });
  };
  if (!has("t_s")) return "t_s";
  if (stream.name.starts_with("device.")) {
    const auto supplies = [](const ColumnMapping& c) {
      return c.channel != "t_s" && c.channel != "host_s" && c.channel != "seq";
    };
    return std::any_of(columns.begin(), columns.end(), supplies) ? ""
                                                                 : "a channel beside its clock";
  }
  if (stream.name == "loadcell")
    return has("force_n") || has("torque_nm") ? "" : "force_n (or torque_nm)";
  const bool input = has("input_angle_rad"), output = has("output_angle_rad");
  const bool deflection = has("deflection_rad");
  if (stream.native && input != output && !deflection)
    return input ? "output_angle_rad" : "input_angle_rad";
  if (!deflection && !(input && output) && !has("current_a"))
    return "deflection_rad (or input_angle_rad and output_angle_rad, or current_a)";
  return "";
}

RecordingMapping read_mapping(const std::filesystem::path& toml_file) {
  const toml::table table = parse_toml(toml_file);
  const Section root(toml_file, "", table);
  const auto format = table["format"].value<std::string>();
  if (format != "searig-recording/1")
    root.refuse(table.get("format"), "format must be \"searig-recording/1\"");

  const Section module = root.section("module");
  const Section loadcell = root.section("loadcell");
  RecordingMapping mapping;
  mapping.module = stream_mapping(module);
  mapping.loadcell = stream_mapping(loadcell);
  mapping.devices = device_mappings(root);
  mapping.gear_ratio = module.positive("gear_ratio").value_or(1.0);
  mapping.lever_arm_m = loadcell.nonzero("lever_arm_m");
  return mapping;
}

}  // namespace searig::acquisition
