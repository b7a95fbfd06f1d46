#include "app/session/export_csv.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "acquisition/clock/device_clock.h"
#include "acquisition/clock/placed_rows.h"
#include "acquisition/recording/text_file.h"

namespace searig::app {
namespace {

using acquisition::append_number;
using acquisition::Channel;
using acquisition::PlacedRows;
using acquisition::Stream;

constexpr double kLongestGap = 5.0;  // sample intervals

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

/// One row of the table: a load-cell sample and the module's rows around it.
struct Moment {
  double t_s = 0.0;  ///< module's clock
  std::size_t loadcell_row = 0;
  std::optional<std::size_t> before;  ///< module row at or before
  std::size_t after = 0;              ///< and the next, where `interpolated`
  double age_s = 0.0;                 ///< from `before` to here
  double share = 0.0;                 ///< of the way from `before` to `after`
  bool interpolated = false;
};

Moment moment_at(double t_s, const PlacedRows& module, double longest_gap) {
  Moment moment;
  moment.t_s = t_s;
  const auto next = static_cast<std::size_t>(
      std::upper_bound(module.t_s.begin(), module.t_s.end(), t_s) - module.t_s.begin());
  if (next == 0) return moment;
  moment.before = module.rows[next - 1];
  moment.age_s = t_s - module.t_s[next - 1];
  const bool last = next == module.t_s.size();
  moment.after = last ? *moment.before : module.rows[next];
  const double gap = last ? 0.0 : module.t_s[next] - module.t_s[next - 1];
  moment.share = last ? 0.0 : moment.age_s / gap;
  moment.interpolated = moment.age_s == 0.0 || (!last && gap <= longest_gap);
  return moment;
}

/// One column of the table: its name, how its values came there, its value at a moment or none.
struct Column {
  std::string name;
  std::string how;
  std::function<std::optional<double>(const Moment&)> value;
};

void add_loadcell(std::vector<Column>& columns, const acquisition::Recording& recording) {
  const Stream& loadcell = recording.loadcell;
  const auto received = [&](std::string name, std::string how, const std::vector<double>& values) {
    columns.push_back({std::move(name), std::move(how),
                       [&values](const Moment& at) { return values[at.loadcell_row]; }});
  };
  received("loadcell_t_s", "s on the load cell's own clock, as received", loadcell.t_s);
  if (!loadcell.host_s.empty())
    received("loadcell_host_s", "s on the host's clock at arrival, as received", loadcell.host_s);
  for (const Channel& channel : loadcell.channels)
    received(channel.name, "as received from the load cell", channel.values);
  if (!loadcell.channel("torque_nm").empty()) return;
  const double arm = recording.lever_arm_m;
  columns.push_back({"torque_nm", "force_n times the lever arm of " + number(arm) + " m",
                     [&loadcell, arm](const Moment& at) {
                       return loadcell.channel("force_n")[at.loadcell_row] * arm;
                     }});
}

void add_module(std::vector<Column>& columns, const Stream& module, double longest_gap) {
  const auto before = [](const std::vector<double>& values) {
    return [&values](const Moment& at) {
      return at.before ? std::optional(values[*at.before]) : std::nullopt;
    };
  };
  columns.push_back({"module_t_s", "s on the module's own clock, of its last row at or before t_s",
                     before(module.t_s)});
  if (!module.host_s.empty())
    columns.push_back(
        {"module_host_s", "s on the host's clock at that row's arrival", before(module.host_s)});
  columns.push_back({"module_age_s", "s from that row to t_s", [](const Moment& at) {
                       return at.before ? std::optional(at.age_s) : std::nullopt;
                     }});
  columns.push_back({"module_valid",
                     "1 where module rows lie on both sides of t_s, no more than " +
                         number(longest_gap) + " s apart; else 0 and the fields behind it empty",
                     [](const Moment& at) { return at.interpolated ? 1.0 : 0.0; }});
  for (const Channel& channel : module.channels)
    columns.push_back({channel.name, "linear between the module's rows around t_s",
                       [&values = channel.values](const Moment& at) -> std::optional<double> {
                         if (!at.interpolated) return std::nullopt;
                         const double from = values[*at.before];
                         return from + at.share * (values[at.after] - from);
                       }});
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

}  // namespace

std::string to_csv_table(const Session& session) {
  const Stream& module = session.recording.module;
  const double longest_gap = kLongestGap * acquisition::median_step(module.t_s);
  std::vector<Column> columns{{"t_s", "", [](const Moment& at) { return at.t_s; }}};
  add_loadcell(columns, session.recording);
  add_module(columns, module, longest_gap);

  std::string text = common_head(session), header;
  for (const Column& column : columns) {
    if (!column.how.empty()) text += "# " + column.name + ": " + column.how + "\n";
    header += (header.empty() ? "" : ",") + column.name;
  }
  text += header + '\n';

  const PlacedRows samples =
      acquisition::place_rows(session.recording.loadcell, session.clock.loadcell_runs);
  const PlacedRows telemetry = acquisition::place_rows(module, session.clock.module_runs);
  for (std::size_t i = 0; i < samples.rows.size(); ++i) {
    Moment moment = moment_at(samples.t_s[i], telemetry, longest_gap);
    moment.loadcell_row = samples.rows[i];
    for (const Column& column : columns) {
      if (const std::optional<double> value = column.value(moment)) append_number(text, *value);
      text += ',';
    }
    text.back() = '\n';
  }
  return text;
}

std::string to_csv_long(const Session& session) {
  std::string text = common_head(session) +
                     "# device_t_s: s on the stream's own clock\n"
                     "t_s,device_t_s,stream,channel,value\n";
  const auto append = [&](const Stream& stream, const std::vector<acquisition::RunMap>& runs) {
    const PlacedRows placed = acquisition::place_rows(stream, runs);
    for (std::size_t i = 0; i < placed.rows.size(); ++i) {
      const std::size_t row = placed.rows[i];
      const std::string begin =
          number(placed.t_s[i]) + ',' + number(stream.t_s[row]) + ',' + stream.name + ',';
      const auto value = [&](std::string_view channel, double v) {
        text.append(begin).append(channel).append(",");
        append_number(text, v);
        text += '\n';
      };
      if (!stream.host_s.empty()) value("host_s", stream.host_s[row]);
      for (const Channel& channel : stream.channels) value(channel.name, channel.values[row]);
    }
  };
  append(session.recording.module, session.clock.module_runs);
  append(session.recording.loadcell, session.clock.loadcell_runs);
  return text;
}

}  // namespace searig::app
