// How the simulated module reaches the host: datagrams or a pseudo terminal.
#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace searig::module {

class Link {
 public:
  using Bytes = std::vector<std::uint8_t>;
  virtual ~Link() = default;
  virtual std::string name() const = 0;  ///< by which the host opens it
  virtual int handle() const = 0;
  virtual Bytes receive() = 0;  ///< one piece from the host, or nothing
  virtual void send(std::span<const std::uint8_t> bytes) = 0;
  virtual void send_as_stranger(std::span<const std::uint8_t>) {}
  virtual void plug(bool in) = 0;
};

/// Listens at HOST:PORT (port 0: any free one) and streams to whom it was last asked by.
class DatagramLink : public Link {
 public:
  DatagramLink(const std::string& host, std::uint16_t port);
  ~DatagramLink() override;
  std::string name() const override;
  int handle() const override { return socket_; }
  Bytes receive() override;
  void send(std::span<const std::uint8_t> bytes) override;
  void send_as_stranger(std::span<const std::uint8_t> bytes) override;
  void plug(bool in) override { plugged_ = in; }

 private:
  int socket_ = -1;
  int stranger_ = -1;
  sockaddr_in host_{};
  double asked_s_ = -1e9;
  bool plugged_ = true;
};

std::unique_ptr<Link> make_serial_link(const std::string& link);

}  // namespace searig::module
