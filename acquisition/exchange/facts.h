// What an export says of a recording beside its columns, so that it can be read back as it was.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "acquisition/exchange/contents.h"

namespace searig::acquisition::exchange {

inline constexpr std::string_view facts_format = "searig-export/1";

/// JSON in ASCII on one line: {"format", "name", "gear_ratio", "lever_arm_m", "one_clock",
/// "model_toml", "calibration", "recorded", "cut_off", "events": [{"host_s", "device", "kind",
/// "text"}], "streams": [{"name", "aligned_by" (of devices), "counts", "restarts", "host_latency",
/// "least_wire_s", "to_module": {"rate", "offset_s", "ci95_s", "trusted", "why", "runs"}}],
/// "groups": [{"name", "rows", "columns"}]}. Where the recording was read from is not in it.
std::string facts_of(const Recording& recording, const ClockMap& clock,
                     const std::vector<ClockMap>& devices, const std::vector<Group>& groups);

/// A group as a file holds it; columns without their values yet, or with them.
struct ReadGroup {
  std::string name;
  std::size_t rows = 0;
  std::vector<Channel> columns;

  const std::vector<double>* find(std::string_view column) const;
};

/// The groups that the facts tell of, in their order, without values. Throws InputError with the
/// rest of a sentence that begins with the file's name, as recording_of() does.
std::vector<ReadGroup> groups_of(std::string_view facts);

/// The recording that these facts and groups are of.
Recording recording_of(std::string_view facts, std::vector<ReadGroup> groups);

}  // namespace searig::acquisition::exchange
