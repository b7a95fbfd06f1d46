#include "acquisition/source/port_list.h"

#include <libserialport.h>

#include <filesystem>

namespace searig::acquisition {
namespace {

namespace fs = std::filesystem;

/// The link in /dev/serial/by-id to a port, or the port itself.
std::string lasting_name(const fs::path& port) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator("/dev/serial/by-id", none))
    if (fs::canonical(entry.path(), none) == port) return entry.path().string();
  return port.string();
}

std::string words_of(const sp_port* port, const fs::path& path) {
  const char* product = sp_get_port_usb_product(port);
  const char* maker = sp_get_port_usb_manufacturer(port);
  const char* said = product != nullptr ? product : maker;
  if (said == nullptr || *said == '\0') return path.filename().string();
  return std::string(said) + " (" + path.filename().string() + ")";
}

}  // namespace

std::vector<ListedPort> list_serial_ports() {
  sp_port** ports = nullptr;
  std::vector<ListedPort> usb, other;
  if (sp_list_ports(&ports) != SP_OK) return usb;
  for (sp_port** port = ports; *port != nullptr; ++port) {
    const fs::path path = sp_get_port_name(*port);
    const bool is_usb = sp_get_port_transport(*port) == SP_TRANSPORT_USB;
    (is_usb ? usb : other).push_back({"serial:" + lasting_name(path), words_of(*port, path)});
  }
  sp_free_port_list(ports);
  usb.insert(usb.end(), other.begin(), other.end());
  return usb;
}

}  // namespace searig::acquisition
