// A module's rows from the first to the last, as often as they are wanted: they need not fit into
// memory.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "acquisition/recording/recording.h"

namespace searig::acquisition {

/// Something befell the rows (one is damaged, doubled, out of order, or the device began anew), so
/// that it takes all of them together to say what they are: read_recording() does.
class NotInOrder : public std::runtime_error {
 public:
  NotInOrder() : std::runtime_error("the module's rows are not all in order") {}
};

class ModuleRows {
 public:
  /// A piece of the stream: times, arrivals and channels, all of one size; nothing else.
  using Take = std::function<void(const Stream& piece)>;
  virtual ~ModuleRows() = default;

  /// Calls `take` with one piece after the other; their rows are those that read_recording() gives,
  /// in its order. Pieces hold the times and those of the channels that there are. The first time
  /// through everything is checked as read_recording() does; later the file is taken to be the
  /// same. Throws NotInOrder, or InputError.
  virtual void go_through(const std::vector<std::string>& channels, const Take& take) const = 0;

  virtual bool has(std::string_view channel) const = 0;
};

/// A recording whose module's rows were left where they are.
struct OpenedRecording {
  Recording recording;  ///< of its module the times at most, see open_recording()
  std::unique_ptr<ModuleRows> rows;
};

/// The recording without the module's channels: of the module there are t_s and host_s, as far as
/// finding the clocks takes them. On one clock that is neither, and t_s is the first time and the
/// last one, or nothing where they are not known yet. Nothing where it has further devices or is no
/// .mcap and no CSV. Throws NotInOrder and InputError.
std::optional<OpenedRecording> open_recording(const std::filesystem::path& path);

}  // namespace searig::acquisition
