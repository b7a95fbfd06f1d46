#include "arduino/module/link.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "acquisition/error.h"
#include "acquisition/source/source.h"
#include "arduino/line/pseudo_terminal.h"

namespace searig::module {
namespace {

constexpr double kForgotten = 5.0;  // s without being asked, after which a host counts as gone

sockaddr* any(sockaddr_in& address) {
  return reinterpret_cast<sockaddr*>(&address);
}

class SerialLink : public Link {
 public:
  explicit SerialLink(const std::string& link) : terminal_(link) { terminal_.plug(); }
  std::string name() const override { return "serial:" + terminal_.path(); }
  int handle() const override { return -1; }  // a terminal that nobody has open always has news
  Bytes receive() override { return terminal_.read(); }
  void send(std::span<const std::uint8_t> bytes) override { terminal_.write(bytes); }
  void plug(bool in) override { in ? terminal_.plug() : terminal_.unplug(); }

 private:
  line::PseudoTerminal terminal_;
};

}  // namespace

DatagramLink::DatagramLink(const std::string& host, std::uint16_t port) {
  sockaddr_in mine{};
  mine.sin_family = AF_INET;
  mine.sin_port = htons(port);
  if (inet_pton(AF_INET, host.c_str(), &mine.sin_addr) != 1) {
    throw acquisition::InputError("'" + host + "' is no address");
  }
  socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  stranger_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (bind(socket_, any(mine), sizeof mine) != 0) {
    throw acquisition::InputError("cannot listen at " + host + ":" + std::to_string(port) + ": " +
                                  std::strerror(errno));
  }
}

DatagramLink::~DatagramLink() {
  close(socket_);
  close(stranger_);
}

std::string DatagramLink::name() const {
  sockaddr_in mine{};
  socklen_t size = sizeof mine;
  getsockname(socket_, any(mine), &size);
  std::array<char, INET_ADDRSTRLEN> text{};
  inet_ntop(AF_INET, &mine.sin_addr, text.data(), text.size());
  return std::string("udp:") + text.data() + ":" + std::to_string(ntohs(mine.sin_port));
}

Link::Bytes DatagramLink::receive() {
  Bytes bytes(512);
  sockaddr_in sender{};
  socklen_t size = sizeof sender;
  const ssize_t count = recvfrom(socket_, bytes.data(), bytes.size(), 0, any(sender), &size);
  bytes.resize(static_cast<std::size_t>(count > 0 && plugged_ ? count : 0));
  if (!bytes.empty()) {
    host_ = sender;
    asked_s_ = acquisition::host_now_s();
  }
  return bytes;
}

void DatagramLink::send(std::span<const std::uint8_t> bytes) {
  if (!plugged_ || acquisition::host_now_s() > asked_s_ + kForgotten) return;
  sendto(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL, any(host_), sizeof host_);
}

void DatagramLink::send_as_stranger(std::span<const std::uint8_t> bytes) {
  if (host_.sin_port == 0) return;
  sendto(stranger_, bytes.data(), bytes.size(), MSG_NOSIGNAL, any(host_), sizeof host_);
}

std::unique_ptr<Link> make_serial_link(const std::string& link) {
  return std::make_unique<SerialLink>(link);
}

}  // namespace searig::module
