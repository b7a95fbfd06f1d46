// Who takes what a device says: a file, a view.
#pragma once

#include <cstddef>
#include <vector>

#include "acquisition/recorder/entry.h"

namespace searig::acquisition {

class EntrySink {
 public:
  virtual ~EntrySink() = default;

  /// Takes the batch and leaves it empty. From any thread; never waits. Returns how many entries of
  /// it are gone because there was no room.
  virtual std::size_t push(std::vector<Entry>& batch) = 0;
};

}  // namespace searig::acquisition
