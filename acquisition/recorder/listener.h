// One who follows a device: decodes what comes from it, from some moment on, for a file or a view.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "acquisition/recorder/device_stream.h"
#include "acquisition/recorder/entry_sink.h"
#include "acquisition/source/source.h"

namespace searig::acquisition {

/// Each listener decodes for itself, from the first bytes that it is given: so the samples of a
/// recording that began in the middle are those of the raw bytes in it, as when it is replayed.
class Listener {
 public:
  Listener(StreamId device, Framing framing, std::optional<CountsToForce> calibration,
           EntrySink& sink)
      : device_(device), stream_(device, framing, calibration), sink_(sink) {}

  /// What the source had counted before is not this one's.
  void begin(const SourceCounters& source) { before_ = source; }
  void take(const Arrival& arrival);
  void tell(double now_s, const SourceCounters& source);
  /// Hands on what has come; where something is lost for want of room that is said, once there is
  /// room again.
  void hand_over(double now_s);

  /// Whether the device has said who it is.
  bool knows_device() const { return stream_.identity().has_value(); }

  struct Report {
    WireCounters counters;
    std::optional<Identity> identity;
    std::string trouble;  ///< the last thing that kept the device from being heard
    bool connected = false;
  };
  Report report() const;  ///< from any thread

 private:
  void publish();

  StreamId device_;
  DeviceStream stream_;
  EntrySink& sink_;
  SourceCounters before_;
  std::vector<Entry> entries_;  // kept for its memory only
  std::size_t overflown_ = 0;
  std::string trouble_;
  bool connected_ = false;

  mutable std::mutex mutex_;
  Report report_;
};

}  // namespace searig::acquisition
