#include "acquisition/source/udp_source.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "acquisition/error.h"
#include "acquisition/wire/encode.h"

namespace searig::acquisition {
namespace {

constexpr std::size_t kLongest = 1472;  // what Ethernet carries in one piece
constexpr double kAskEvery = 1.0;       // s
constexpr double kSilent = 1.0;         // s after which a module counts as gone
constexpr int kBuffer = 1 << 20;        // bytes: seconds of telemetry, should we be kept waiting

sockaddr_in resolve(const std::string& host, std::uint16_t port) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  if (const int error = getaddrinfo(host.c_str(), nullptr, &hints, &found); error != 0) {
    throw InputError("'" + host + "' has no address: " + gai_strerror(error));
  }
  sockaddr_in address{};
  std::memcpy(&address, found->ai_addr, sizeof address);
  freeaddrinfo(found);
  address.sin_port = htons(port);
  return address;
}

const sockaddr* any(const sockaddr_in& address) {
  return reinterpret_cast<const sockaddr*>(&address);
}

sockaddr* any(sockaddr_in& address) {
  return reinterpret_cast<sockaddr*>(&address);
}

/// The address on this side of the way to another.
sockaddr_in this_side_of(const sockaddr_in& other) {
  sockaddr_in mine{};
  socklen_t size = sizeof mine;
  const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const bool found =
      connect(probe, any(other), sizeof other) == 0 && getsockname(probe, any(mine), &size) == 0;
  const int error = errno;
  ::close(probe);
  if (!found) throw InputError(std::string("no way to the module: ") + std::strerror(error));
  mine.sin_port = 0;
  return mine;
}

}  // namespace

UdpSource::UdpSource(std::string host, std::uint16_t port)
    : host_(std::move(host)), port_(port), module_(resolve(host_, port)) {
  const sockaddr_in mine = this_side_of(module_);
  socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket_ < 0 || bind(socket_, any(mine), sizeof mine) != 0) {
    const std::string why = std::strerror(errno);
    if (socket_ >= 0) ::close(socket_);
    throw InputError("no socket for " + name() + ": " + why);
  }
  setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &kBuffer, sizeof kBuffer);
  ask(host_now_s());
}

UdpSource::~UdpSource() {
  ::close(socket_);
}

double UdpSource::wake_s() const {
  return connected_ ? std::min(next_ask_s_, heard_s_ + kSilent) : next_ask_s_;
}

void UdpSource::ask(double host_s) {
  send(identify_frame());
  next_ask_s_ = host_s + kAskEvery;
}

bool UdpSource::from_module(const sockaddr_in& sender) const {
  return sender.sin_addr.s_addr == module_.sin_addr.s_addr && sender.sin_port == module_.sin_port;
}

void UdpSource::tell_connection(std::vector<Arrival>& arrivals, double host_s) {
  heard_s_ = host_s;
  if (connected_) return;
  connected_ = true;
  counters_.reconnected += was_connected_;
  const auto kind = was_connected_ ? Arrival::Kind::reconnected : Arrival::Kind::connected;
  arrivals.push_back({kind, host_s, {}, name() + (was_connected_ ? " is back" : " answers")});
  was_connected_ = true;
}

void UdpSource::tell_silence(std::vector<Arrival>& arrivals, double host_s) {
  if (!connected_ || host_s < heard_s_ + kSilent) return;
  connected_ = false;
  ++counters_.unplugged;
  arrivals.push_back({Arrival::Kind::unplugged, host_s, {}, name() + " is silent"});
}

void UdpSource::read(std::vector<Arrival>& arrivals) {
  std::array<std::uint8_t, kLongest> buffer;
  for (;;) {
    sockaddr_in sender{};
    socklen_t size = sizeof sender;
    // With MSG_TRUNC the datagram's own length comes back, also where it did not fit.
    const ssize_t count =
        recvfrom(socket_, buffer.data(), buffer.size(), MSG_TRUNC, any(sender), &size);
    const double host_s = host_now_s();
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      tell_silence(arrivals, host_s);
      if (host_s >= next_ask_s_) ask(host_s);
      return;
    }
    if (!from_module(sender)) {
      ++counters_.foreign;
    } else if (static_cast<std::size_t>(count) > kLongest) {
      ++counters_.too_long;
    } else {
      tell_connection(arrivals, host_s);
      counters_.bytes += static_cast<std::uint64_t>(count);
      arrivals.push_back(
          {Arrival::Kind::bytes, host_s, {buffer.begin(), buffer.begin() + count}, {}});
    }
  }
}

void UdpSource::send(std::span<const std::uint8_t> bytes) {
  const ssize_t sent =
      sendto(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL, any(module_), sizeof module_);
  counters_.unsent += bytes.size() - static_cast<std::size_t>(std::max<ssize_t>(0, sent));
}

}  // namespace searig::acquisition
