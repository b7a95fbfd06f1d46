// The serial ports of this machine, for people to choose from.
#pragma once

#include <string>
#include <vector>

namespace searig::acquisition {

struct ListedPort {
  std::string source;  ///< what opens it: "serial:/dev/serial/by-id/usb-Arduino..."
  std::string words;   ///< "Arduino Uno (ttyACM0)"
};

/// USB devices first. Those that name themselves are opened by that name, under which they are
/// found again wherever they are plugged in.
std::vector<ListedPort> list_serial_ports();

}  // namespace searig::acquisition
