#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

namespace searig::proving {

/// How well a tool's place fits the true one, as intersection over union of the module's rows;
/// nothing when the truth is not local or the tool names no place.
/// Places are {"intervals_s": [...], "regions": [{"channel","from","to"}]}, the truth's also
/// {"instants_s"}: there an interval boundary or a narrow interval within a second counts as 1.
std::optional<double> overlap(const nlohmann::json& truth, const nlohmann::json& answer,
                              const std::filesystem::path& recording);

}  // namespace searig::proving
