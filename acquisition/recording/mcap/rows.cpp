#include "acquisition/recording/mcap/rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/recording/mcap/cdr.h"

namespace searig::acquisition::mcap {
namespace {

/// Row numbers by run and device time, each moment once.
struct Order {
  std::vector<std::size_t> rows;
  std::vector<std::size_t> restarts;
  std::vector<double> runs;  ///< the numbers of the runs that have rows
  std::size_t doubled = 0;
};

Order order_of(const Rows& rows) {
  const std::vector<double>& t_s = *rows.find("t_s");
  const std::vector<double>* run = rows.find("run");
  const auto run_of = [&](std::size_t row) { return run ? (*run)[row] : 0.0; };
  std::vector<std::size_t> sorted(rows.size());
  std::iota(sorted.begin(), sorted.end(), std::size_t{0});
  std::stable_sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
    return run_of(a) != run_of(b) ? run_of(a) < run_of(b) : t_s[a] < t_s[b];
  });
  Order order;
  for (const std::size_t row : sorted) {
    const bool first = order.rows.empty();
    const bool restart = !first && run_of(row) != run_of(order.rows.back());
    if (!first && !restart && t_s[row] == t_s[order.rows.back()]) {
      ++order.doubled;
      continue;
    }
    if (restart) order.restarts.push_back(order.rows.size());
    if (first || restart) order.runs.push_back(run_of(row));
    order.rows.push_back(row);
  }
  return order;
}

std::vector<double> picked(const std::vector<double>& values,
                           const std::vector<std::size_t>& rows) {
  std::vector<double> result(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) result[i] = values[rows[i]];
  return result;
}

std::size_t last_of(const Rows& counters, std::string_view name) {
  const std::vector<double>* column = counters.find(name);
  return column && !column->empty() ? static_cast<std::size_t>(std::max(0.0, column->back())) : 0;
}

/// The pings of those runs; in a file of another program there may be none, or others.
std::vector<Exchange> exchanges_of(const Rows& pings, const std::vector<double>& runs) {
  std::vector<Exchange> exchanges;
  const auto *host_s = pings.find("host_s"), *host_sent_s = pings.find("host_sent_s"),
             *received_s = pings.find("device_received_s"), *sent_s = pings.find("device_s"),
             *run = pings.find("run");
  if (!host_s || !host_sent_s || !received_s || !sent_s || !run) return exchanges;
  for (std::size_t row = 0; row < pings.size(); ++row) {
    const auto place = std::find(runs.begin(), runs.end(), (*run)[row]);
    if (place == runs.end()) continue;
    exchanges.push_back({(*host_sent_s)[row], (*received_s)[row], (*sent_s)[row], (*host_s)[row],
                         std::size_t(place - runs.begin())});
  }
  return exchanges;
}

bool is_channel(const std::string& name) {
  return name != "t_s" && name != "host_s" && name != "run";
}

}  // namespace

bool Rows::parse(std::string_view message, std::vector<double>& row) const {
  row.resize(names.size());
  const std::size_t bytes = row.size() * sizeof(double);  // CDR puts doubles one after the other
  if (message.size() != cdr_head.size() + bytes || !message.starts_with(cdr_head)) return false;
  std::memcpy(row.data(), message.data() + cdr_head.size(), bytes);
  return std::all_of(row.begin(), row.end(), [](double v) { return std::isfinite(v); });
}

void Rows::take(std::string_view message) {
  if (!parse(message, row_)) {
    ++garbled;
    return;
  }
  for (std::size_t i = 0; i < row_.size(); ++i) columns[i].push_back(row_[i]);
}

const std::vector<double>* Rows::find(std::string_view name) const {
  const auto at = std::find(names.begin(), names.end(), name);
  return at == names.end() ? nullptr : &columns[std::size_t(at - names.begin())];
}

Stream stream_of(const std::string& name, const ReceivedRows& received,
                 const StreamSettings& settings) {
  const Rows& rows = received.samples;
  const Rows& counters = received.counters;
  Stream stream;
  stream.name = name;
  stream.host_latency = settings.host_latency;
  if (!rows.find("t_s")) return stream;

  Order order;
  if (settings.sorted) {
    order.rows.resize(rows.size());
    std::iota(order.rows.begin(), order.rows.end(), std::size_t{0});
    for (const std::size_t restart : settings.sorted->restarts)  // of a file cut off there are less
      if (restart < rows.size()) order.restarts.push_back(restart);
    order.runs.resize(order.restarts.size() + 1);
    std::iota(order.runs.begin(), order.runs.end(), 0.0);
    stream.least_wire_s = settings.sorted->least_wire_s;
    stream.counts = settings.sorted->counts;
    stream.counts.garbled += rows.garbled;
  } else {
    order = order_of(rows);
    stream.counts.lost = last_of(counters, "lost");
    stream.counts.doubled = last_of(counters, "doubled") + order.doubled;
    stream.counts.garbled = last_of(counters, "garbled") + rows.garbled;
    stream.counts.out_of_order = last_of(counters, "out_of_order");
  }
  stream.counts.received = order.rows.size();
  stream.t_s = picked(*rows.find("t_s"), order.rows);
  if (const auto* host_s = rows.find("host_s")) stream.host_s = picked(*host_s, order.rows);
  for (std::size_t i = 0; i < rows.names.size(); ++i)
    if (is_channel(rows.names[i]))
      stream.channels.push_back({rows.names[i], picked(rows.columns[i], order.rows)});
  stream.restarts = std::move(order.restarts);
  stream.pings = exchanges_of(received.pings, order.runs);
  return stream;
}

Stream stream_in_order(Stream times, double run, const ReceivedRows& received,
                       const StreamSettings& settings) {
  Stream stream = std::move(times);
  stream.host_latency = settings.host_latency;
  if (settings.sorted) stream.least_wire_s = settings.sorted->least_wire_s;
  stream.pings = exchanges_of(received.pings, {settings.sorted ? 0.0 : run});
  return stream;
}

void refuse_unusable(const Recording& recording, bool module_alone, const std::string& file) {
  for (const Stream* stream : {&recording.module, &recording.loadcell})
    if (stream->t_s.empty() && !(module_alone && stream == &recording.loadcell))
      throw InputError(file + ": holds no samples of the " +
                       (stream == &recording.module ? "module." : "load cell."));
  if (!recording.loadcell.t_s.empty() && recording.loadcell.channel("force_n").empty() &&
      recording.loadcell.channel("torque_nm").empty())
    throw InputError(file + ": the load cell was not calibrated, so its counts are no force; " +
                     "searig calibrate makes a calibration to record with.");
}

}  // namespace searig::acquisition::mcap
