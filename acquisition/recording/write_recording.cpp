#include "acquisition/recording/write_recording.h"

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "acquisition/recording/text_file.h"

namespace searig::acquisition {
namespace {

struct NamedColumn {
  std::string name;
  std::span<const double> values;
};

std::vector<NamedColumn> columns_of(const Stream& stream, bool with_host) {
  std::vector<NamedColumn> columns{{"t_s", stream.t_s}};
  if (with_host && !stream.host_s.empty()) columns.push_back({"host_s", stream.host_s});
  for (const Channel& channel : stream.channels) columns.push_back({channel.name, channel.values});
  for (const NamedColumn& column : columns)
    if (column.values.size() != stream.t_s.size())
      throw std::invalid_argument(stream.name + "." + column.name + " has " +
                                  std::to_string(column.values.size()) + " values for " +
                                  std::to_string(stream.t_s.size()) + " rows.");
  return columns;
}

std::string csv(const Stream& stream, bool with_host) {
  const std::vector<NamedColumn> columns = columns_of(stream, with_host);
  std::string text;
  text.reserve(stream.t_s.size() * columns.size() * 12 + 100);
  for (const NamedColumn& column : columns)
    text.append(text.empty() ? "" : ",").append(column.name);
  text += '\n';
  for (std::size_t row = 0; row < stream.t_s.size(); ++row) {
    for (const NamedColumn& column : columns) {
      if (!std::isfinite(column.values[row]))
        throw std::invalid_argument(stream.name + "." + column.name + ", row " +
                                    std::to_string(row) + " is not finite.");
      if (&column != &columns.front()) text += ',';
      append_number(text, column.values[row]);
    }
    text += '\n';
  }
  return text;
}

void append_key(std::string& toml, const char* key, double value) {
  toml.append(key).append(" = ");
  const std::size_t begin = toml.size();
  append_number(toml, value);
  if (toml.find_first_of(".e", begin) == std::string::npos) toml += ".0";  // TOML tells 1 from 1.0
  toml += '\n';
}

void append_latency(std::string& toml, const Stream& stream) {
  if (!stream.host_latency) return;
  append_key(toml, "host_latency_s", stream.host_latency->latency_s);
  append_key(toml, "host_latency_ci95_s", stream.host_latency->ci95_s);
}

}  // namespace

void write_recording(const Recording& recording, const std::filesystem::path& folder) {
  std::string toml = "format = \"searig-recording/1\"\n\n[module]\nfile = \"module.csv\"\n";
  append_key(toml, "gear_ratio", recording.gear_ratio);
  append_latency(toml, recording.module);
  toml += "\n[loadcell]\nfile = \"loadcell.csv\"\n";
  append_key(toml, "lever_arm_m", recording.lever_arm_m);
  append_latency(toml, recording.loadcell);

  const std::string module = csv(recording.module, true);
  const std::string loadcell = csv(recording.loadcell, !recording.one_clock);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw std::runtime_error(folder.string() + ": cannot be made: " + error.message() + ".");
  write_text_file(folder / "module.csv", module);
  write_text_file(folder / "loadcell.csv", loadcell);
  write_text_file(folder / "recording.toml", toml);  // last: it makes the folder a recording
}

}  // namespace searig::acquisition
