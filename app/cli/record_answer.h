// How a recording stands, or what it came to: in a line for people and as JSON for machines.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "acquisition/recorder/recorder.h"

namespace searig::app {

/// "10.0 s   module 5002, lost 0, garbled 0   load cell 500, ...   clocks +-0.1 ms"
std::string state_line(const acquisition::RecorderState& state);

nlohmann::json record_answer(const std::filesystem::path& file,
                             const acquisition::RecorderState& state);

}  // namespace searig::app
