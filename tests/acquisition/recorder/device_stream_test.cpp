// One recording through everything that befalls a device, in simulated time: what is listed, and
// that no wrong sample gets into it.
#include "acquisition/recorder/device_stream.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "acquisition/error.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "arduino/firmware/payloads.h"

namespace searig::acquisition {
namespace {

/// A 50 Hz load cell whose counts say when they were taken: 20 ms each, over all its starts.
class FakeLoadcell {
 public:
  double host_s = 100.0;
  std::uint64_t time_us = 0;
  std::uint16_t boot = 1;
  std::uint32_t sequence = 0;
  std::int32_t counts = 0;

  Arrival next() {
    wire::LoadcellPayload payload{};
    payload.counts = ++counts;
    host_s += 0.02;
    time_us += 20000;
    return frame(wire::Type::loadcell_sample, sequence++, payload);
  }
  Arrival identity() {
    wire::IdentityPayload who{};
    who.kind = wire::DeviceKind::loadcell_hx711;
    who.rate_mhz = 50000;
    who.newton_per_count = 0.5f;
    return frame(wire::Type::identity, 0, who);
  }
  Arrival event(Arrival::Kind kind) const { return {kind, host_s, {}, "It happened."}; }
  void restart() {
    ++boot;
    sequence = 0;
    time_us = 1000;
  }

 private:
  template <typename Payload>
  Arrival frame(wire::Type type, std::uint32_t number, const Payload& payload) {
    std::uint8_t content[wire::kMaxPayload] = {};
    payload.write(content);
    Arrival arrival{Arrival::Kind::bytes, host_s, std::vector<std::uint8_t>(wire::kMaxEncoded), {}};
    arrival.bytes.resize(wire::encode(
        {wire::kProtocolVersion, type, boot, number, static_cast<std::uint32_t>(time_us)}, content,
        Payload::kSize, arrival.bytes.data()));
    return arrival;
  }
};

/// What a recorder would make of it, as a file.
struct Recorded {
  DeviceStream stream{StreamId::loadcell, Framing::stream};
  std::vector<Entry> entries;
  SourceCounters source;

  void take(const Arrival& arrival) { stream.take(arrival, entries); }
  void tell(double host_s) { stream.tell(host_s, source, entries); }

  Recording read() const {
    std::string bytes;
    mcap::RecordingWriter out([&](std::string_view piece) { bytes.append(piece); }, "test", 0.0);
    out.settings({}, 0.0);
    out.set_columns(StreamId::module, {"t_s", "host_s", "seq", "run", "current_a"});
    out.sample(StreamId::module, 0.0, std::vector{0.0, 0.0, 0.0, 0.0, 0.0});
    for (const Entry& entry : entries) write_entry(entry, out);
    out.file().finish();
    return mcap::recording_of(bytes, "test");
  }
};

std::set<std::string> kinds(const Recording& recording) {
  std::set<std::string> out;
  for (const Event& event : recording.events) out.insert(event.kind);
  return out;
}

TEST(DeviceStream, AnHourOfEverythingIsOneRecordingWithEachEventAndNoWrongSample) {
  FakeLoadcell cell;
  cell.time_us = 4'294'967'296ull - 1'000'000'000ull;  // wraps after 1000 s
  Recorded recorded;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  recorded.take(cell.event(Arrival::Kind::connected));
  recorded.take(cell.identity());
  std::size_t whole = 0;
  constexpr int samples = 50 * 3600;
  for (int i = 0; i < samples; ++i) {
    if (i == 100000) {  // three seconds without a cable
      recorded.take(cell.event(Arrival::Kind::unplugged));
      for (int k = 0; k < 150; ++k) (void)cell.next();
      recorded.take(cell.event(Arrival::Kind::reconnected));
    }
    if (i == 150000) cell.restart();
    Arrival arrival = cell.next();
    if (share(random) < 0.01) continue;  // lost
    bool touched = false;
    for (std::uint8_t& byte : arrival.bytes)
      for (int bit = 0; bit < 8; ++bit)
        if (share(random) < 0.001) byte = std::uint8_t(byte ^ (1 << bit)), touched = true;
    whole += !touched;
    recorded.take(arrival);
    if (i % 50 == 0) recorded.tell(cell.host_s);
  }
  recorded.tell(cell.host_s);

  const Recording read = recorded.read();
  for (const char* kind :
       {"connected", "unplugged", "reconnected", "reset", "wrap", "lost", "garbled", "identity"})
    EXPECT_TRUE(kinds(read).contains(kind)) << kind;
  const Stream& stream = read.loadcell;
  EXPECT_EQ(stream.restarts.size(), 1u);
  EXPECT_GT(stream.counts.garbled, 20000u);
  EXPECT_GT(stream.counts.lost, 1500u);
  EXPECT_GT(stream.t_s.size(), whole * 9 / 10);  // a flipped end takes the next frame with it

  // Counts say when each was taken: on the device's clock, wraps undone, in each of its runs.
  const std::vector<double>&counts = stream.channel("counts"), &force = stream.channel("force_n");
  const std::size_t restart = stream.restarts.at(0);
  for (std::size_t i = 0; i < stream.t_s.size(); ++i) {
    const std::size_t first = i < restart ? 0 : restart;
    ASSERT_NEAR(stream.t_s[i] - stream.t_s[first], 0.02 * (counts[i] - counts[first]), 1e-6) << i;
    ASSERT_EQ(force[i], 0.5 * counts[i]);
  }
}

TEST(DeviceStream, ALoadCellWithoutCalibrationIsRecordedAndSaidToBeNone) {
  FakeLoadcell cell;
  Recorded recorded;
  for (int i = 0; i < 100; ++i) recorded.take(cell.next());
  std::size_t rows = 0;
  std::set<std::string> events;
  for (const Entry& entry : recorded.entries) {
    rows += std::holds_alternative<SampleRow>(entry);
    if (const auto* event = std::get_if<Event>(&entry)) events.insert(event->kind);
  }
  EXPECT_EQ(rows, 100u);
  EXPECT_TRUE(events.contains("uncalibrated"));
  EXPECT_THROW((void)recorded.read(), InputError);
}

}  // namespace
}  // namespace searig::acquisition
