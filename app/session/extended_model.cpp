#include "app/session/extended_model.h"

#include <string>

#include "acquisition/recording/text_file.h"

namespace searig::app {

std::filesystem::path keep_extended_model(const std::filesystem::path& recording,
                                          const estimator::Model& model) {
  namespace fs = std::filesystem;
  const bool folder = fs::is_directory(recording);
  const fs::path place = folder ? recording : recording.parent_path();
  const std::string name = folder ? "extended" : recording.stem().string() + ".extended";
  fs::path file = place / (name + ".toml");
  for (int i = 2; fs::exists(file); ++i) file = place / (name + "-" + std::to_string(i) + ".toml");
  acquisition::write_text_file(file, estimator::to_toml(model));
  return file;
}

}  // namespace searig::app
