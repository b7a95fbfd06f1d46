#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/proving/plan/make_case.h"

namespace searig::proving {

/// recording.toml, module.csv, loadcell.csv and the owner's model.toml.
void write_recording(const Case& c, const std::filesystem::path& folder);

/// The sealed truth about one recording.
nlohmann::json answer_for(const Case& c);

}  // namespace searig::proving
