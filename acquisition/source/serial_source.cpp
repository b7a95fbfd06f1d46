#include "acquisition/source/serial_source.h"

#include <array>
#include <limits>
#include <utility>

#include "acquisition/error.h"

namespace searig::acquisition {
namespace {

constexpr double kTryEvery = 0.1;  // s; costs one look at the file system

}  // namespace

SerialSource::SerialSource(std::unique_ptr<Port> port, std::string device, unsigned baud)
    : device_(std::move(device)), baud_(baud), port_(std::move(port)) {
  const Port::Opened opened = open();
  if (opened == Port::Opened::busy || opened == Port::Opened::refused) {
    throw InputError(port_->why());
  }
  try_again(untold_);
}

double SerialSource::wake_s() const {
  if (!untold_.empty() || gone_) return 0.0;
  return port_->is_open() ? std::numeric_limits<double>::infinity() : next_try_s_;
}

Port::Opened SerialSource::open() {
  const Port::Opened opened = port_->open(device_, baud_);
  next_try_s_ = host_now_s() + kTryEvery;
  if (opened == Port::Opened::yes) counters_.stale += port_->stale();
  return opened;
}

/// Says what the last opening came to.
void SerialSource::try_again(std::vector<Arrival>& arrivals) {
  Arrival event;
  event.host_s = host_now_s();
  if (port_->is_open()) {
    event.kind = was_connected_ ? Arrival::Kind::reconnected : Arrival::Kind::connected;
    event.what = device_ + (was_connected_ ? " is back" : " is open");
    counters_.reconnected += was_connected_;
    was_connected_ = true;
    said_.clear();
  } else if (port_->why() != said_) {
    event.kind = Arrival::Kind::unusable;
    event.what = said_ = port_->why();
  } else {
    return;
  }
  arrivals.push_back(std::move(event));
}

void SerialSource::lose(std::vector<Arrival>& arrivals, double host_s) {
  port_->close();
  gone_ = false;
  next_try_s_ = host_s + kTryEvery;
  ++counters_.unplugged;
  said_ = device_ + " is not there";  // so unplugged is not said twice
  arrivals.push_back({Arrival::Kind::unplugged, host_s, {}, device_ + " is gone"});
}

void SerialSource::read(std::vector<Arrival>& arrivals) {
  for (Arrival& event : std::exchange(untold_, {})) arrivals.push_back(std::move(event));
  if (!port_->is_open()) {
    if (host_now_s() < next_try_s_) return;
    open();
    try_again(arrivals);
    if (!port_->is_open()) return;
  }
  std::array<std::uint8_t, 4096> buffer;
  for (;;) {
    const int count = port_->read(buffer);
    const double host_s = host_now_s();
    if (count < 0 || (count == 0 && gone_)) return lose(arrivals, host_s);
    if (count == 0) return;
    counters_.bytes += static_cast<std::uint64_t>(count);
    arrivals.push_back(
        {Arrival::Kind::bytes, host_s, {buffer.begin(), buffer.begin() + count}, {}});
  }
}

void SerialSource::send(std::span<const std::uint8_t> bytes) {
  const int taken = port_->is_open() ? port_->write(bytes) : 0;
  if (taken < 0) gone_ = true;
  counters_.unsent += bytes.size() - static_cast<std::size_t>(taken > 0 ? taken : 0);
}

}  // namespace searig::acquisition
