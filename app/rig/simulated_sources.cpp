#include "app/rig/simulated_sources.h"

#include <cmath>
#include <cstring>
#include <mutex>

#include "arduino/firmware/payloads.h"

namespace searig::app {
namespace {

using acquisition::Arrival;
using acquisition::Stream;

constexpr double look_every_s = 0.004;
constexpr std::int32_t tare_counts = 84213;
constexpr float newton_per_count = 0.0005f;

/// The rig in real time, which both sources drive, each from a thread of its own.
struct RunningRig {
  RunningRig(const RigSettings& settings, const std::function<double()>& host)
      : rig(settings), host_s(host), started_s(host()) {}
  void run() { rig.run_until(host_s() - started_s); }

  std::mutex mutex;
  SimulatedRig rig;
  std::function<double()> host_s;
  double started_s;
};

std::int32_t micro(double si) {
  return static_cast<std::int32_t>(std::lround(1e6 * si));
}

template <typename Payload>
std::vector<std::uint8_t> frame(wire::Type type, std::uint32_t sequence, double device_s,
                                const Payload& payload) {
  std::uint8_t content[wire::kMaxPayload] = {};
  payload.write(content);
  const auto time_us = static_cast<std::uint32_t>(std::llround(1e6 * device_s));
  std::vector<std::uint8_t> bytes(wire::kMaxEncoded);
  bytes.resize(wire::encode({wire::kProtocolVersion, type, 1, sequence, time_us}, content,
                            Payload::kSize, bytes.data()));
  return bytes;
}

wire::IdentityPayload identity(wire::DeviceKind kind, const char* name, double rate_hz) {
  wire::IdentityPayload out{};
  out.kind = kind;
  out.firmware_version = 1;
  out.rate_mhz = static_cast<std::uint32_t>(1000.0 * rate_hz);
  std::strncpy(out.name, name, sizeof out.name);
  return out;
}

class SimulatedSource : public acquisition::Source {
 public:
  SimulatedSource(std::shared_ptr<RunningRig> running, const LinkSettings& link)
      : running_(std::move(running)), link_(link) {}

  std::string name() const override { return "sim:"; }
  int handle() const override { return -1; }
  double wake_s() const override { return looked_s_ + look_every_s; }
  void send(std::span<const std::uint8_t>) override {}
  const acquisition::SourceCounters& counters() const override { return counters_; }

  void read(std::vector<Arrival>& arrivals) override {
    looked_s_ = running_->host_s();
    if (next_ == 0 && counters_.bytes == 0) {
      arrivals.push_back(
          {Arrival::Kind::connected, running_->started_s, {}, "The simulated rig runs."});
      hand_on(arrivals, running_->started_s, introduction());
    }
    const std::lock_guard lock(running_->mutex);
    running_->run();
    const Stream& stream = this->stream(running_->rig.recording());
    for (; next_ < stream.t_s.size(); ++next_) {
      // The device's beat is even by its own clock, so its time tells how many went before.
      const double beats = (stream.t_s[next_] - link_.clock.offset_s) * link_.rate_hz;
      hand_on(arrivals, running_->started_s + stream.host_s[next_],
              sample(stream, next_, static_cast<std::uint32_t>(std::lround(beats)) - 1));
    }
  }

 protected:
  virtual const Stream& stream(const acquisition::Recording& recording) const = 0;
  virtual std::vector<std::uint8_t> introduction() const = 0;
  virtual std::vector<std::uint8_t> sample(const Stream& stream, std::size_t row,
                                           std::uint32_t sequence) const = 0;

  const LinkSettings& link() const { return link_; }

 private:
  void hand_on(std::vector<Arrival>& arrivals, double host_s, std::vector<std::uint8_t> bytes) {
    counters_.bytes += bytes.size();
    arrivals.push_back({Arrival::Kind::bytes, host_s, std::move(bytes), {}});
  }

  std::shared_ptr<RunningRig> running_;
  LinkSettings link_;
  std::size_t next_ = 0;
  double looked_s_ = 0.0;
  acquisition::SourceCounters counters_;
};

class SimulatedModule : public SimulatedSource {
 public:
  SimulatedModule(std::shared_ptr<RunningRig> running, const RigSettings& settings)
      : SimulatedSource(std::move(running), settings.module),
        gear_ratio_(settings.parameters.drive.gear_ratio) {}

 private:
  const Stream& stream(const acquisition::Recording& r) const override { return r.module; }
  std::vector<std::uint8_t> introduction() const override {
    wire::IdentityPayload who = identity(wire::DeviceKind::module, "twin", link().rate_hz);
    who.gear_ratio = static_cast<float>(gear_ratio_);
    return frame(wire::Type::identity, 0, link().clock.offset_s, who);
  }
  std::vector<std::uint8_t> sample(const Stream& stream, std::size_t row,
                                   std::uint32_t sequence) const override {
    wire::ModulePayload out{};
    out.input_angle_urad = micro(stream.channels[0].values[row]);
    out.output_angle_urad = micro(stream.channels[1].values[row]);
    out.current_ua = micro(stream.channels[2].values[row]);
    out.commanded_angle_urad = micro(stream.channels[3].values[row]);
    out.input_velocity_urad_s = wire::kAbsent32;
    out.winding_temperature_cc = out.spring_temperature_cc = wire::kAbsent16;
    return frame(wire::Type::module_sample, sequence, stream.t_s[row], out);
  }

  double gear_ratio_;
};

class SimulatedLoadcell : public SimulatedSource {
 public:
  SimulatedLoadcell(std::shared_ptr<RunningRig> running, const RigSettings& settings)
      : SimulatedSource(std::move(running), settings.loadcell) {}

 private:
  const Stream& stream(const acquisition::Recording& r) const override { return r.loadcell; }
  std::vector<std::uint8_t> introduction() const override {
    wire::IdentityPayload who =
        identity(wire::DeviceKind::loadcell_hx711, "simulated", link().rate_hz);
    who.tare_counts = tare_counts;
    who.newton_per_count = newton_per_count;
    return frame(wire::Type::identity, 0, link().clock.offset_s, who);
  }
  std::vector<std::uint8_t> sample(const Stream& stream, std::size_t row,
                                   std::uint32_t sequence) const override {
    wire::LoadcellPayload out{};
    const double force_n = stream.channels[0].values[row];
    out.counts = static_cast<std::int32_t>(std::lround(force_n / newton_per_count)) + tare_counts;
    return frame(wire::Type::loadcell_sample, sequence, stream.t_s[row], out);
  }
};

}  // namespace

SimulatedSources simulated_sources(const RigSettings& settings,
                                   const std::function<double()>& host_s) {
  const auto running = std::make_shared<RunningRig>(settings, host_s);
  return {std::make_unique<SimulatedModule>(running, settings),
          std::make_unique<SimulatedLoadcell>(running, settings)};
}

}  // namespace searig::app
