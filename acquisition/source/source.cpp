#include "acquisition/source/source.h"

#include <poll.h>
#include <time.h>

#include <algorithm>
#include <cmath>

#include "acquisition/error.h"
#include "acquisition/source/serial_port.h"
#include "acquisition/source/serial_source.h"
#include "acquisition/source/udp_source.h"

namespace searig::acquisition {
namespace {

constexpr unsigned kUsualBaud = 115200;

/// The number at the end of "name<separator>number"; the name is cut to what is before it.
unsigned number_behind(std::string_view& name, char separator, std::string_view whole) {
  const std::size_t place = name.rfind(separator);
  const std::string digits(name.substr(std::min(place, name.size() - 1) + 1));
  name = name.substr(0, place);
  if (place == std::string_view::npos || digits.empty() || digits.size() > 7 ||
      digits.find_first_not_of("0123456789") != std::string::npos) {
    throw InputError("'" + std::string(whole) + "' does not end in " + separator + "NUMBER");
  }
  return static_cast<unsigned>(std::stoul(digits));
}

std::unique_ptr<Source> open_serial(std::string_view device, std::string_view whole) {
  unsigned baud = kUsualBaud;
  if (device.find('@') != std::string_view::npos) baud = number_behind(device, '@', whole);
  if (device.empty()) throw InputError("'" + std::string(whole) + "' names no device");
  return std::make_unique<SerialSource>(std::make_unique<SerialPort>(), std::string(device), baud);
}

std::unique_ptr<Source> open_udp(std::string_view address, std::string_view whole) {
  const unsigned port = number_behind(address, ':', whole);
  if (port == 0 || port > 65535) {
    throw InputError("'" + std::string(whole) + "': a port is a number from 1 to 65535");
  }
  return std::make_unique<UdpSource>(address.empty() ? "127.0.0.1" : std::string(address),
                                     static_cast<std::uint16_t>(port));
}

}  // namespace

double host_now_s() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

std::string_view name_of(Arrival::Kind kind) {
  switch (kind) {
    case Arrival::Kind::bytes:
      return "bytes";
    case Arrival::Kind::connected:
      return "connected";
    case Arrival::Kind::unplugged:
      return "unplugged";
    case Arrival::Kind::reconnected:
      return "reconnected";
    case Arrival::Kind::unusable:
      return "unusable";
  }
  return "";
}

void wait_for(std::span<Source* const> sources, double timeout_s) {
  const double now = host_now_s();
  double until = now + timeout_s;
  std::vector<pollfd> handles;
  for (const Source* source : sources) {
    until = std::min(until, source->wake_s());
    if (source->handle() >= 0) handles.push_back({source->handle(), POLLIN, 0});
  }
  const double wait_s = std::max(0.0, until - now);
  timespec wait{};
  wait.tv_sec = static_cast<time_t>(wait_s);
  wait.tv_nsec = static_cast<long>((wait_s - std::floor(wait_s)) * 1e9);
  ppoll(handles.data(), handles.size(), &wait, nullptr);
}

std::unique_ptr<Source> open_source(std::string_view name) {
  std::string_view rest = name;
  const auto cut = [&rest](std::string_view prefix) {
    if (!rest.starts_with(prefix)) return false;
    rest.remove_prefix(prefix.size());
    if (rest.starts_with("//")) rest.remove_prefix(2);
    return true;
  };
  if (cut("udp:")) return open_udp(rest, name);
  if (cut("serial:") || rest.starts_with("/")) return open_serial(rest, name);
  throw InputError("'" + std::string(name) +
                   "' is no source: serial:DEVICE, udp:HOST:PORT or the path of a device");
}

}  // namespace searig::acquisition
