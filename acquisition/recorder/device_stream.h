// One device while it is recorded: what comes from its source, as entries for the file.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "acquisition/recorder/entry.h"
#include "acquisition/source/source.h"
#include "acquisition/wire/decoder.h"

namespace searig::acquisition {

/// force_n = (counts - tare_counts) * newton_per_count
struct CountsToForce {
  double tare_counts = 0.0;
  double newton_per_count = 0.0;
};

/// Decodes arrivals and notes what befalls the device. The same arrivals give the same entries,
/// whether they come from a source or from a file.
class DeviceStream {
 public:
  /// Without a calibration of its own, the load cell's stored one is used, which its identity
  /// tells.
  DeviceStream(StreamId device, Framing framing, std::optional<CountsToForce> calibration = {});

  void take(const Arrival& arrival, std::vector<Entry>& entries);

  /// Once a second: counters, and what they say of the last second.
  void tell(double host_s, const SourceCounters& source, std::vector<Entry>& entries);

  const WireCounters& counters() const { return decoder_.counters(); }
  const std::optional<Identity>& identity() const { return identity_; }
  bool calibrated() const { return calibration_.has_value(); }

 private:
  void take(const LoadcellSample& sample, std::vector<Entry>& entries);
  void take(const ModuleSample& sample, std::vector<Entry>& entries);
  void take(const Pong& pong, std::vector<Entry>& entries);
  void take(const Identity& identity, std::vector<Entry>& entries);
  void take(const Restart& restart, std::vector<Entry>& entries);

  void note(double host_s, const char* kind, const std::string& text, std::vector<Entry>& entries);
  void note_wrap(const Stamp& at, std::vector<Entry>& entries);
  void hand_on(const LoadcellSample& sample, std::vector<Entry>& entries);
  void hand_on_waiting(std::vector<Entry>& entries);

  StreamId device_;
  Decoder decoder_;
  std::optional<CountsToForce> given_, calibration_;
  std::optional<Identity> identity_;
  std::vector<Message> messages_;  // kept for its memory only

  bool has_columns_ = false, with_force_ = false;
  std::vector<double ModuleSample::*> channels_;  // of the module, those it has
  std::vector<LoadcellSample> waiting_;           // for the calibration in the identity

  WireCounters told_;  // at the last tell()
  double wraps_ = 0.0;
  std::uint32_t run_ = 0;
};

/// Who it is, in a few words: "loadcell, firmware 1".
std::string words_of(const Identity& identity);

/// What is wrong with frames that were read but not taken.
std::uint64_t garbled(const WireCounters& counters);

}  // namespace searig::acquisition
