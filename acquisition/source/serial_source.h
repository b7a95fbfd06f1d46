// A device on a line that may be unplugged and come back.
#pragma once

#include <memory>

#include "acquisition/source/port.h"
#include "acquisition/source/source.h"

namespace searig::acquisition {

class SerialSource : public Source {
 public:
  /// Throws InputError where the port is in use or refuses; an absent one is waited for.
  SerialSource(std::unique_ptr<Port> port, std::string device, unsigned baud);

  std::string name() const override { return "serial:" + device_; }
  unsigned baud() const override { return baud_; }
  int handle() const override { return port_->handle(); }
  double wake_s() const override;
  void read(std::vector<Arrival>& arrivals) override;
  void send(std::span<const std::uint8_t> bytes) override;
  const SourceCounters& counters() const override { return counters_; }

 private:
  Port::Opened open();
  void try_again(std::vector<Arrival>& arrivals);
  void lose(std::vector<Arrival>& arrivals, double host_s);

  std::string device_;
  unsigned baud_;
  std::unique_ptr<Port> port_;
  SourceCounters counters_;
  std::vector<Arrival> untold_;  ///< what happened in the constructor
  bool was_connected_ = false;
  bool gone_ = false;  ///< noticed while sending
  double next_try_s_ = 0.0;
  std::string said_;  ///< the last reason given
};

}  // namespace searig::acquisition
