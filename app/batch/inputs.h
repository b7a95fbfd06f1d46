// Which recordings a command was given: by name, in folders, in a list.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace searig::app {

struct Inputs {
  std::vector<std::string> recordings;  ///< in the order given, each once; in a folder sorted
  bool searched = false;                ///< whether a folder or a list was looked through
};

/// A folder with a recording.toml is a recording, and so is any file. Any other folder stands for
/// every recording below it: folders with a recording.toml, and .mcap files, sorted by the bytes of
/// their paths; links to folders are not followed, unless they are recordings. A folder that holds
/// none, or cannot be read, stays in as itself, so that whoever opens it says what is wrong.
/// `list` is a file with such a path on each line; empty lines and those that begin with # say
/// nothing. Throws InputError where it cannot be read or names nothing.
Inputs find_recordings(const std::vector<std::string>& given,
                       const std::optional<std::string>& list = {});

/// What a recording is called: its folder or file without the rest of the path.
std::string name_of(const std::string& recording);

}  // namespace searig::app
