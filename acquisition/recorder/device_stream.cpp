#include "acquisition/recorder/device_stream.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace searig::acquisition {
namespace {

constexpr double wrap_s = 4294.967296;       // 2^32 us
constexpr double identity_patience_s = 0.5;  // samples wait so long for a load cell's identity

constexpr std::array<std::pair<const char*, double ModuleSample::*>, 7> module_channels{{
    {"input_angle_rad", &ModuleSample::input_angle_rad},
    {"output_angle_rad", &ModuleSample::output_angle_rad},
    {"current_a", &ModuleSample::current_a},
    {"commanded_angle_rad", &ModuleSample::commanded_angle_rad},
    {"input_velocity_rad_s", &ModuleSample::input_velocity_rad_s},
    {"winding_temperature_c", &ModuleSample::winding_temperature_c},
    {"spring_temperature_c", &ModuleSample::spring_temperature_c},
}};

std::vector<double> stamped(const Stamp& at) {
  return {at.device_s, at.host_s, double(at.sequence), double(at.run)};
}

const std::vector<std::string> stamp_names{"t_s", "host_s", "seq", "run"};

std::string counted(std::uint64_t count, const char* one, const char* more) {
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

}  // namespace

std::uint64_t garbled(const WireCounters& counters) {
  const ParserCounters& p = counters.parser;
  return p.bad_crc + p.malformed + p.too_long + p.other_version + p.unknown_type +
         counters.implausible;
}

std::string words_of(const Identity& identity) {
  return identity.name + ", firmware " + std::to_string(identity.firmware_version);
}

DeviceStream::DeviceStream(StreamId device, Framing framing,
                           std::optional<CountsToForce> calibration)
    : device_(device), decoder_(framing), given_(calibration), calibration_(calibration) {}

void DeviceStream::note(double host_s, const char* kind, const std::string& text,
                        std::vector<Entry>& entries) {
  entries.push_back(Event{host_s, mcap::name_of(device_), kind, text});
}

void DeviceStream::take(const Arrival& arrival, std::vector<Entry>& entries) {
  if (arrival.kind != Arrival::Kind::bytes) {
    if (arrival.kind == Arrival::Kind::unplugged) decoder_.gap();
    note(arrival.host_s, std::string(name_of(arrival.kind)).c_str(), arrival.what, entries);
    return;
  }
  entries.push_back(RawPiece{device_, arrival.host_s, arrival.bytes});
  messages_.clear();
  decoder_.push(arrival.bytes, arrival.host_s, messages_);
  for (const Message& message : messages_)
    std::visit([&](const auto& m) { take(m, entries); }, message);
}

void DeviceStream::note_wrap(const Stamp& at, std::vector<Entry>& entries) {
  const double wraps = std::floor(at.device_s / wrap_s);
  if (at.run == run_ && wraps > wraps_)
    note(at.host_s, "wrap", "The device's microseconds began again at zero; time goes on.",
         entries);
  run_ = at.run;
  wraps_ = wraps;
}

void DeviceStream::take(const ModuleSample& sample, std::vector<Entry>& entries) {
  if (device_ != StreamId::module) return;
  note_wrap(sample.at, entries);
  if (!has_columns_) {  // what a module does not have it never sends
    Columns columns{device_, stamp_names};
    for (const auto& [name, channel] : module_channels) {
      if (std::isnan(sample.*channel)) continue;
      columns.names.push_back(name);
      channels_.push_back(channel);
    }
    entries.push_back(std::move(columns));
    has_columns_ = true;
  }
  SampleRow row{device_, stamped(sample.at)};
  for (const auto channel : channels_) row.values.push_back(sample.*channel);
  entries.push_back(std::move(row));
}

void DeviceStream::take(const LoadcellSample& sample, std::vector<Entry>& entries) {
  if (device_ != StreamId::loadcell) return;
  note_wrap(sample.at, entries);
  if (sample.repeated) return;  // the reading was handed on already; its frame is in the raw bytes
  if (has_columns_) return hand_on(sample, entries);
  waiting_.push_back(sample);
  if (calibration_ || sample.at.host_s > waiting_.front().at.host_s + identity_patience_s)
    hand_on_waiting(entries);
}

void DeviceStream::hand_on_waiting(std::vector<Entry>& entries) {
  Columns columns{device_, stamp_names};
  columns.names.push_back("counts");
  with_force_ = calibration_.has_value();
  if (with_force_) columns.names.push_back("force_n");
  entries.push_back(std::move(columns));
  has_columns_ = true;
  if (!with_force_)
    note(waiting_.front().at.host_s, "uncalibrated",
         "The load cell is not calibrated: its counts are kept, but they are no force.", entries);
  for (const LoadcellSample& sample : waiting_) hand_on(sample, entries);
  waiting_.clear();
}

void DeviceStream::hand_on(const LoadcellSample& sample, std::vector<Entry>& entries) {
  SampleRow row{device_, stamped(sample.at)};
  row.values.push_back(sample.counts);
  if (with_force_)
    row.values.push_back((sample.counts - calibration_->tare_counts) *
                         calibration_->newton_per_count);
  entries.push_back(std::move(row));
}

void DeviceStream::take(const Pong& pong, std::vector<Entry>& entries) {
  entries.push_back(PingRow{device_,
                            {pong.at.host_s, pong.host_sent_s, pong.device_received_s,
                             pong.at.device_s, double(pong.at.run)}});
}

void DeviceStream::take(const Identity& identity, std::vector<Entry>& entries) {
  const bool same = identity_ && identity_->name == identity.name &&
                    identity_->kind == identity.kind &&
                    identity_->firmware_version == identity.firmware_version &&
                    identity_->tare_counts == identity.tare_counts &&
                    identity_->newton_per_count == identity.newton_per_count;
  identity_ = identity;
  if (!given_ && device_ == StreamId::loadcell && identity.newton_per_count != 0.0)
    calibration_ = {double(identity.tare_counts), identity.newton_per_count};
  if (same) return;  // it was asked again
  char text[160];
  int end = std::snprintf(text, sizeof text, "\"%s\", firmware %d, %.6g Hz", identity.name.c_str(),
                          int(identity.firmware_version), identity.rate_hz);
  if (device_ == StreamId::loadcell)
    end += std::snprintf(text + end, sizeof text - std::size_t(end), ", tare %d, %.9g N per count",
                         int(identity.tare_counts), identity.newton_per_count);
  std::snprintf(text + end, sizeof text - std::size_t(end), ".");
  note(identity.at.host_s, "identity", text, entries);
  if (!waiting_.empty()) hand_on_waiting(entries);
}

void DeviceStream::take(const Restart& restart, std::vector<Entry>& entries) {
  if (restart.run == 0) return;  // its first start seen here
  if (restart.paused)
    note(restart.host_s, "gap",
         "The device paused: its clock stood still while it was not heard, and goes on.", entries);
  else
    note(restart.host_s, "reset", "The device began anew: its clock and its sequences too.",
         entries);
}

void DeviceStream::tell(double host_s, const SourceCounters& source, std::vector<Entry>& entries) {
  const WireCounters& now = counters();
  if (now.lost_samples > told_.lost_samples)
    note(
        host_s, "lost",
        counted(now.lost_samples - told_.lost_samples, "sample never came.", "samples never came."),
        entries);
  if (garbled(now) > garbled(told_))
    note(host_s, "garbled",
         counted(garbled(now) - garbled(told_), "frame was damaged and left out.",
                 "frames were damaged and left out."),
         entries);
  if (now.at_limit > 0 && told_.at_limit == 0)
    note(host_s, "limit", "The load cell's converter is at the end of its range.", entries);
  if (now.repeated > told_.repeated && told_.repeated == 0)
    note(host_s, "repeated",
         "The load cell's converter is slower than its frames: readings repeat.", entries);
  told_ = now;
  entries.push_back(CountersRow{
      device_,
      {host_s, double(now.samples), double(now.lost_samples), double(now.doubled),
       double(now.out_of_order), double(garbled(now)), double(now.restarts), double(source.bytes),
       double(source.foreign + source.too_long), double(now.repeated), double(now.at_limit),
       double(now.device_overruns), double(source.unplugged)}});
}

}  // namespace searig::acquisition
