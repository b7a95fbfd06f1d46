#include "acquisition/recorder/replay.h"

#include <map>
#include <optional>
#include <string>

#include "acquisition/recording/mcap/cdr.h"
#include "acquisition/recording/mcap/layout.h"

namespace searig::acquisition {
namespace {

std::optional<StreamId> device_named(std::string_view name) {
  for (const StreamId device : {StreamId::module, StreamId::loadcell})
    if (name == mcap::name_of(device)) return device;
  return std::nullopt;
}

std::optional<Arrival::Kind> kind_named(std::string_view name) {
  using Kind = Arrival::Kind;
  for (const Kind kind : {Kind::connected, Kind::unplugged, Kind::reconnected, Kind::unusable})
    if (name == name_of(kind)) return kind;
  return std::nullopt;
}

class Replay : public mcap::Handler {
 public:
  explicit Replay(const TakeArrival& take) : take_(take) {}

  void channel(const mcap::Channel& channel, const mcap::Schema&) override {
    if (channel.topic == mcap::events_topic) events_ = channel.id;
    for (const StreamId device : {StreamId::module, StreamId::loadcell})
      if (channel.topic == std::string("/") + mcap::name_of(device) + mcap::raw_suffix)
        raw_[channel.id] = device;
  }

  void message(const mcap::Message& message) override {
    if (message.channel == events_) return take_event(message.data);
    const auto device = raw_.find(message.channel);
    if (device == raw_.end()) return;
    mcap::CdrReader reader(message.data);
    arrival_.kind = Arrival::Kind::bytes;
    arrival_.host_s = reader.number<double>();
    const std::string_view bytes = reader.raw();
    arrival_.bytes.assign(bytes.begin(), bytes.end());
    arrival_.what.clear();
    if (reader.fits()) take_(device->second, arrival_);
  }

 private:
  void take_event(std::string_view data) {
    mcap::CdrReader reader(data);
    arrival_.host_s = reader.number<double>();
    const auto device = device_named(reader.text());
    const auto kind = kind_named(reader.text());
    if (!device || !kind) return;  // an event that the decoding found, and will find again
    arrival_.kind = *kind;
    arrival_.bytes.clear();
    arrival_.what = reader.text();
    take_(*device, arrival_);
  }

  const TakeArrival& take_;
  Arrival arrival_;
  std::map<std::uint16_t, StreamId> raw_;
  int events_ = -1;
};

}  // namespace

mcap::Ending replay(std::string_view file, const TakeArrival& take) {
  Replay replaying(take);
  return mcap::read(file, replaying);
}

}  // namespace searig::acquisition
