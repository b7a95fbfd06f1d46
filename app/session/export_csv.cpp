#include "app/session/export_csv.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "acquisition/clock/device_clock.h"
#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/text_file.h"

namespace searig::app {
namespace {

using acquisition::append_number;
using acquisition::Stream;

constexpr double kGap = 5.0;  // sample intervals

/// The module's rows around a moment: `before` is the last one at or before it.
struct Around {
  std::size_t before = 0;
  double share = 0.0;  ///< of the way to the next row
  double age_s = 0.0;
  bool any_before = false;
  bool valid = false;
};

/// Row numbers of a stream in order of the module's clock, with their times there.
struct Timeline {
  std::vector<double> t_s;
  std::vector<std::size_t> rows;

  Timeline(const Stream& stream, const std::vector<acquisition::RunMap>& runs) {
    const std::vector<double> all = acquisition::on_module_clock(stream, runs);
    for (std::size_t row = 0; row < all.size(); ++row)
      if (!std::isnan(all[row])) rows.push_back(row);
    std::stable_sort(rows.begin(), rows.end(),
                     [&](std::size_t a, std::size_t b) { return all[a] < all[b]; });
    for (const std::size_t row : rows) t_s.push_back(all[row]);
  }

  Around around(double moment, double longest_gap) const {
    const auto after = std::upper_bound(t_s.begin(), t_s.end(), moment) - t_s.begin();
    Around result;
    if (after == 0) return result;
    const auto before = static_cast<std::size_t>(after) - 1;
    result.any_before = true;
    result.before = before;
    result.age_s = moment - t_s[before];
    if (result.age_s == 0.0) {
      result.valid = true;
    } else if (before + 1 < t_s.size()) {
      const double gap = t_s[before + 1] - t_s[before];
      result.share = result.age_s / gap;
      result.valid = gap <= longest_gap;
    }
    return result;
  }
};

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string common_head(const Session& session) {
  const acquisition::ClockMap& clock = session.clock;
  return "# searig export of " + session.recording.name +
         "\n# t_s: s on the module's clock; load-cell samples come there by " + number(clock.rate) +
         " * loadcell_t_s + " + number(clock.offset_s) +
         (clock.loadcell_runs.size() > 1 ? " (longest run; others through the host)" : "") +
         "\n# 95 % interval of that: +-" + number(clock.ci95_s) + " s; " +
         (clock.trusted ? "trusted: " : "NOT TRUSTED: ") + clock.why + "\n";
}

std::string table_head(const Session& session, double longest_gap) {
  const Stream& loadcell = session.recording.loadcell;
  const Stream& module = session.recording.module;
  std::string head = common_head(session);
  head += "# loadcell_t_s, loadcell_host_s: s, device clock and arrival, as received\n";
  for (const acquisition::Channel& channel : loadcell.channels)
    head += "# " + channel.name + ": as received from the load cell\n";
  if (loadcell.channel("torque_nm").empty())
    head += "# torque_nm: force_n times the lever arm of " + number(session.recording.lever_arm_m) +
            " m\n";
  head += "# module_t_s, module_host_s: s, the last module row at or before t_s, as received\n";
  head += "# module_age_s: s from that row to t_s\n";
  head += "# module_valid: 1 where module rows lie on both sides of t_s, no more than " +
          number(longest_gap) + " s apart; else 0, and the module's fields are empty\n";
  for (const acquisition::Channel& channel : module.channels)
    head += "# " + channel.name + ": linear between the module rows around t_s\n";
  return head;
}

}  // namespace

std::string to_csv_table(const Session& session) {
  const Stream& loadcell = session.recording.loadcell;
  const Stream& module = session.recording.module;
  const double longest_gap = kGap * acquisition::median_step(module.t_s);
  const Timeline samples(loadcell, session.clock.loadcell_runs);
  const Timeline telemetry(module, session.clock.module_runs);
  const bool torque_from_force = loadcell.channel("torque_nm").empty();

  std::string text = table_head(session, longest_gap) + "t_s,loadcell_t_s";
  if (!loadcell.host_s.empty()) text += ",loadcell_host_s";
  for (const acquisition::Channel& channel : loadcell.channels) text += "," + channel.name;
  if (torque_from_force) text += ",torque_nm";
  text += ",module_t_s";
  if (!module.host_s.empty()) text += ",module_host_s";
  text += ",module_age_s,module_valid";
  for (const acquisition::Channel& channel : module.channels) text += "," + channel.name;
  text += '\n';

  const auto field = [&](double value) {
    text += ',';
    append_number(text, value);
  };
  for (std::size_t i = 0; i < samples.rows.size(); ++i) {
    const std::size_t row = samples.rows[i];
    append_number(text, samples.t_s[i]);
    field(loadcell.t_s[row]);
    if (!loadcell.host_s.empty()) field(loadcell.host_s[row]);
    for (const acquisition::Channel& channel : loadcell.channels) field(channel.values[row]);
    if (torque_from_force) field(loadcell.channel("force_n")[row] * session.recording.lever_arm_m);

    const Around around = telemetry.around(samples.t_s[i], longest_gap);
    if (!around.any_before) {
      text.append(module.host_s.empty() ? ",,,0" : ",,,,0").append(module.channels.size(), ',');
      text += '\n';
      continue;
    }
    const std::size_t before = telemetry.rows[around.before];
    field(module.t_s[before]);
    if (!module.host_s.empty()) field(module.host_s[before]);
    field(around.age_s);
    text += around.valid ? ",1" : ",0";
    for (const acquisition::Channel& channel : module.channels) {
      if (!around.valid) {
        text += ',';
        continue;
      }
      const double from = channel.values[before];
      const double to =
          around.share == 0.0 ? from : channel.values[telemetry.rows[around.before + 1]];
      field(from + around.share * (to - from));
    }
    text += '\n';
  }
  return text;
}

std::string to_csv_long(const Session& session) {
  std::string text = common_head(session) +
                     "# device_t_s: s on the stream's own clock\n"
                     "t_s,device_t_s,stream,channel,value\n";
  const auto append = [&](const Stream& stream, const std::vector<acquisition::RunMap>& runs) {
    const Timeline line(stream, runs);
    for (std::size_t i = 0; i < line.rows.size(); ++i) {
      const std::size_t row = line.rows[i];
      std::string begin = number(line.t_s[i]) + ',' + number(stream.t_s[row]) + ',' + stream.name;
      const auto value = [&](std::string_view channel, double v) {
        text.append(begin).append(",").append(channel).append(",");
        append_number(text, v);
        text += '\n';
      };
      if (!stream.host_s.empty()) value("host_s", stream.host_s[row]);
      for (const acquisition::Channel& channel : stream.channels)
        value(channel.name, channel.values[row]);
    }
  };
  append(session.recording.module, session.clock.module_runs);
  append(session.recording.loadcell, session.clock.loadcell_runs);
  return text;
}

}  // namespace searig::app
