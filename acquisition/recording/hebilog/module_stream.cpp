#include "acquisition/recording/hebilog/module_stream.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "acquisition/clock/device_clock.h"
#include "acquisition/recording/hebilog/channels.h"

namespace searig::acquisition::hebilog {
namespace {

std::vector<double> seconds(const std::vector<double>& us) {
  std::vector<double> values;
  for (const double value : us) values.push_back(value / 1e6);
  return values;
}

}  // namespace

std::vector<double> at(const std::vector<std::size_t>& rows, const std::vector<double>& values) {
  std::vector<double> picked;
  for (const std::size_t row : rows) picked.push_back(values[row]);
  return picked;
}

Stream stream_of(Log& log, std::vector<std::size_t>& order) {
  const std::vector<double> t_s = seconds(log.field(hardware_sent_us));
  std::vector<double> host_s;
  for (const std::uint64_t us : log.log_us) host_s.push_back(double(us) / 1e6);
  std::vector<double> seq = log.field(sequence);
  const bool counted = std::ranges::none_of(seq, [](double v) { return std::isnan(v); });
  if (!counted) seq.clear();
  ClockedRows rows = read_device_clock(t_s, host_s, seq);

  Stream stream;
  stream.name = "module";
  stream.t_s = std::move(rows.t_s);
  stream.host_s = at(rows.order, host_s);
  if (counted) stream.channels.push_back({"seq", at(rows.order, seq)});
  stream.restarts = std::move(rows.restarts);
  stream.counts = {rows.order.size(), rows.lost, rows.doubled, rows.astray, rows.out_of_order};
  order = std::move(rows.order);
  return stream;
}

void add_pings(Stream& stream, Log& log, const std::vector<std::size_t>& order) {
  const std::vector<double> sent = at(order, seconds(log.field(host_sent_us)));
  const std::vector<double> received = at(order, seconds(log.field(hardware_received_us)));
  std::size_t run = 0;
  for (std::size_t row = 0; row < order.size(); ++row) {
    if (run < stream.restarts.size() && row == stream.restarts[run]) ++run;
    if (!std::isnan(sent[row]) && !std::isnan(received[row]))
      stream.pings.push_back({sent[row], received[row], stream.t_s[row], stream.host_s[row], run});
  }
}

}  // namespace searig::acquisition::hebilog
