// Shards of one batch, done anywhere, put together.
#pragma once

#include <filesystem>
#include <vector>

#include "app/batch/summary.h"

namespace searig::app {

/// The answers of all shards in the order of the whole list: what one machine would have given.
/// Throws InputError with one sentence where a folder holds no batch, where they are of different
/// batches, or where a recording is not done yet.
Summary merge_shards(const std::vector<std::filesystem::path>& folders);

}  // namespace searig::app
