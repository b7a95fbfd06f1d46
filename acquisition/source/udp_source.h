// A module that streams frames in datagrams, one or more whole frames in each.
#pragma once

#include <netinet/in.h>

#include "acquisition/source/source.h"

namespace searig::acquisition {

/// HOST:PORT is the module. It streams to whom it was last asked by (wire::Type::identify), so this
/// asks at the start, and once a second. The socket is bound to the address on this side of the way
/// to the module: for a module on loopback nobody else can reach it.
class UdpSource : public Source {
 public:
  /// Throws InputError where the host has no address or cannot be reached.
  UdpSource(std::string host, std::uint16_t port);
  ~UdpSource() override;
  UdpSource(const UdpSource&) = delete;
  UdpSource& operator=(const UdpSource&) = delete;

  std::string name() const override { return "udp:" + host_ + ":" + std::to_string(port_); }
  int handle() const override { return socket_; }
  double wake_s() const override;
  void read(std::vector<Arrival>& arrivals) override;
  void send(std::span<const std::uint8_t> bytes) override;
  const SourceCounters& counters() const override { return counters_; }

 private:
  void ask(double host_s);
  bool from_module(const sockaddr_in& sender) const;
  void tell_connection(std::vector<Arrival>& arrivals, double host_s);
  void tell_silence(std::vector<Arrival>& arrivals, double host_s);

  std::string host_;
  std::uint16_t port_;
  sockaddr_in module_{};
  int socket_ = -1;
  SourceCounters counters_;
  double next_ask_s_ = 0.0;
  double heard_s_ = 0.0;  ///< the last datagram
  bool connected_ = false;
  bool was_connected_ = false;
};

}  // namespace searig::acquisition
