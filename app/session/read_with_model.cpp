#include "app/session/read_with_model.h"

#include <optional>

#include "acquisition/recording/mcap/read_mcap.h"
#include "acquisition/recording/text_file.h"
#include "app/session/session.h"

namespace searig::app {

acquisition::Recording read_with_model(const std::filesystem::path& path) {
  acquisition::Recording recording = acquisition::read_recording(path);
  if (acquisition::mcap::is_mcap(path)) return recording;
  const auto folder = std::filesystem::is_directory(path) ? path : path.parent_path();
  if (find_model(path, std::nullopt))
    recording.model_toml = acquisition::read_text_file(folder / "model.toml");
  return recording;
}

}  // namespace searig::app
