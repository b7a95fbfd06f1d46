#include "acquisition/exchange/table.h"

#include <limits>
#include <utility>

#include "acquisition/clock/device_clock.h"
#include "acquisition/clock/placed_rows.h"
#include "acquisition/recording/text_file.h"
#include "acquisition/recording/units.h"

namespace searig::acquisition::exchange {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

/// A stream's rows around a sample.
struct Around {
  bool heard = false;  ///< there is a row at or before
  bool valid = false;  ///< and what lies between may be interpolated
  std::size_t before = 0, after = 0;
  double age_s = none;  ///< from `before` to the sample
  double share = 0.0;   ///< of the way from `before` to `after`
};

/// For each of the rising times, the rows of a stream around it.
std::vector<Around> rows_around(std::span<const double> times, const PlacedRows& stream,
                                double gap_s) {
  std::vector<Around> all(times.size());
  std::size_t next = 0;  // the first row behind the sample
  for (std::size_t i = 0; i < times.size(); ++i) {
    while (next < stream.t_s.size() && stream.t_s[next] <= times[i]) ++next;
    if (next == 0) continue;
    Around& around = all[i];
    const bool last = next == stream.t_s.size();
    const double step = last ? 0.0 : stream.t_s[next] - stream.t_s[next - 1];
    around.heard = true;
    around.before = stream.rows[next - 1];
    around.after = last ? around.before : stream.rows[next];
    around.age_s = times[i] - stream.t_s[next - 1];
    around.share = last ? 0.0 : around.age_s / step;
    around.valid = around.age_s == 0.0 || (!last && step <= gap_s);
  }
  return all;
}

class TableMaker {
 public:
  TableMaker(Contents& contents, const Stream& loadcell, const ClockMap& clock)
      : contents_(contents), placed_(place_rows(loadcell, clock.loadcell_runs)) {
    table_ = {"table", "A row for each load-cell sample, everything brought to its time.", {}};
    add("t_s", "on the module's clock", contents.keep(placed_.t_s));
  }

  void add_loadcell(const Stream& loadcell, double lever_arm_m) {
    add("loadcell_t_s", "on the load cell's own clock, as received", at(loadcell.t_s));
    if (!loadcell.host_s.empty())
      add("loadcell_host_s", "on the host's clock at arrival, as received", at(loadcell.host_s));
    for (const Channel& channel : loadcell.channels)
      add(own_name(channel.name, "loadcell"), "as received from the load cell", at(channel.values));
    if (!loadcell.channel("torque_nm").empty() || loadcell.channel("force_n").empty()) return;
    std::vector<double> torque = at_rows(loadcell.channel("force_n"), placed_);
    for (double& value : torque) value *= lever_arm_m;
    add("torque_nm", "force_n times the lever arm of " + number(lever_arm_m) + " m",
        contents_.keep(std::move(torque)));
  }

  /// `whose`: "module", or a device's name without "device."
  void add_stream(const Stream& stream, const std::vector<RunMap>& runs, const std::string& whose) {
    const PlacedRows rows = place_rows(stream, runs);
    const double gap_s = longest_gap * median_step(rows.t_s);
    const std::vector<Around> around = rows_around(placed_.t_s, rows, gap_s);
    const auto each = [&](auto value) {
      std::vector<double> values(around.size(), none);
      for (std::size_t i = 0; i < around.size(); ++i) values[i] = value(around[i]);
      return contents_.keep(std::move(values));
    };
    const auto last = [&](const std::vector<double>& values) {
      return each([&](const Around& a) { return a.heard ? values[a.before] : none; });
    };
    const std::string last_row = ", of its last row at or before t_s";
    add(whose + "_t_s", "on the clock of " + whose + last_row, last(stream.t_s));
    if (!stream.host_s.empty())
      add(whose + "_host_s", "on the host's clock at arrival" + last_row, last(stream.host_s));
    add(whose + "_age_s", "from that row to t_s", each([](const Around& a) { return a.age_s; }));
    add(whose + "_valid",
        "1 where rows of " + whose + " lie on both sides of t_s, no more than " + number(gap_s) +
            " s apart; else 0 and what comes of them is missing",
        each([](const Around& a) { return a.valid ? 1.0 : 0.0; }));
    for (const Channel& channel : stream.channels) {
      const std::vector<double>& values = channel.values;
      if (channel.name == "seq")
        add(own_name(channel.name, whose), "as received" + last_row, last(values));
      else
        add(own_name(channel.name, whose), "linear between the rows of " + whose + " around t_s",
            each([&](const Around& a) {
              return a.valid ? values[a.before] + a.share * (values[a.after] - values[a.before])
                             : none;
            }));
    }
  }

  Group done() { return std::move(table_); }

 private:
  void add(std::string name, std::string how, std::span<const double> values) {
    std::string unit(unit_of(name));
    table_.columns.push_back({std::move(name), std::move(unit), std::move(how), values});
  }

  std::span<const double> at(const std::vector<double>& values) {
    return contents_.keep(at_rows(values, placed_));
  }

  /// What several streams have bears the stream's name too.
  std::string own_name(const std::string& name, const std::string& whose) const {
    return name == "seq" || table_.find(name) ? whose + "_" + name : name;
  }

  Contents& contents_;
  PlacedRows placed_;
  Group table_;
};

}  // namespace

Group table_of(Contents& contents, const Recording& recording, const ClockMap& clock,
               const std::vector<ClockMap>& devices) {
  if (recording.loadcell.t_s.empty()) return {"table", "There is no load cell.", {}};
  TableMaker table(contents, recording.loadcell, clock);
  table.add_loadcell(recording.loadcell, recording.lever_arm_m);
  table.add_stream(recording.module, clock.module_runs, "module");
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const Stream& stream = recording.devices[i].stream;
    table.add_stream(stream, devices[i].loadcell_runs,
                     stream.name.substr(stream.name.find('.') + 1));
  }
  return table.done();
}

}  // namespace searig::acquisition::exchange
