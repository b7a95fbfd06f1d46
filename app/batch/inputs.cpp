#include "app/batch/inputs.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

#include "acquisition/error.h"
#include "acquisition/recording/csv_row.h"
#include "acquisition/recording/text_file.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;

bool is_recording_folder(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / "recording.toml", ignored);
}

/// Everything below `folder` that is a recording, into `found`.
void search(const fs::path& folder, std::vector<std::string>& found) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored)) {
      if (is_recording_folder(entry->path()))
        found.push_back(entry->path().string());
      else if (!entry->is_symlink(ignored))
        search(entry->path(), found);
    } else if (entry->path().extension() == ".mcap") {
      found.push_back(entry->path().string());
    }
  }
  if (error) found.push_back(folder.string());
}

std::vector<std::string> lines_of(const std::string& list) {
  const std::string text = acquisition::read_text_file(list);
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view line = acquisition::trimmed(acquisition::line_at(text, at, at));
    if (!line.empty() && line.front() != '#') lines.emplace_back(line);
  }
  if (lines.empty()) throw acquisition::InputError(list + ": names no recording.");
  return lines;
}

}  // namespace

Inputs find_recordings(const std::vector<std::string>& given,
                       const std::optional<std::string>& list) {
  std::vector<std::string> named = given;
  Inputs out;
  if (list) {
    const auto lines = lines_of(*list);
    named.insert(named.end(), lines.begin(), lines.end());
    out.searched = true;
  }
  std::set<std::string> seen;
  const auto add = [&](const std::string& recording) {
    const fs::path path = fs::path(recording).lexically_normal();
    const fs::path bare = path.has_filename() ? path : path.parent_path();
    if (seen.insert(bare.string()).second) out.recordings.push_back(recording);
  };
  for (const std::string& path : named) {
    std::error_code ignored;
    std::vector<std::string> found;
    if (fs::is_directory(path, ignored) && !is_recording_folder(path)) search(path, found);
    if (found.empty() || (found.size() == 1 && found.front() == path)) {
      add(path);
      continue;
    }
    out.searched = true;
    std::ranges::sort(found);
    for (const std::string& recording : found) add(recording);
  }
  return out;
}

std::string name_of(const std::string& recording) {
  const fs::path path = fs::path(recording).lexically_normal();
  if (path.extension() == ".mcap") return path.stem().string();
  return path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
}

}  // namespace searig::app
