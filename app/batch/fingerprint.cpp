#include "app/batch/fingerprint.h"

#include <sys/stat.h>

#include <exception>
#include <set>

#include "acquisition/recording/mapping.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;

/// The files that a folder's recording.toml names, as far as it can be read.
std::set<fs::path> files_of(const fs::path& toml) {
  std::set<fs::path> files{toml, toml.parent_path() / "model.toml"};
  try {
    const acquisition::RecordingMapping mapping = acquisition::read_mapping(toml);
    files.insert({mapping.module.file, mapping.loadcell.file});
    for (const auto& device : mapping.devices) files.insert(device.stream.file);
  } catch (const std::exception&) {  // whoever opens the recording will say what is wrong
  }
  return files;
}

}  // namespace

Fingerprint fingerprint_of(const fs::path& recording) {
  std::error_code ignored;
  std::set<fs::path> files{recording};
  if (fs::is_directory(recording, ignored))
    files = files_of(recording / "recording.toml");
  else if (recording.extension() == ".toml")
    files = files_of(recording);
  Fingerprint out;
  for (const fs::path& file : files) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) continue;
    out.bytes += std::uint64_t(status.st_size);
    out.text += (out.text.empty() ? "" : ", ") + file.filename().string() + " " +
                std::to_string(status.st_size) + " " + std::to_string(status.st_mtim.tv_sec) + "." +
                std::to_string(status.st_mtim.tv_nsec);
  }
  return out;
}

}  // namespace searig::app
