#pragma once

#include <filesystem>
#include <vector>

#include "tests/proving/plan/stratum.h"

namespace searig::proving {

/// Writes DIR/recordings/<name>/ and, apart from them, DIR/answers.json.
void generate(const std::vector<Item>& items, const std::filesystem::path& directory, int threads);

}  // namespace searig::proving
