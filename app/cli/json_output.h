// The answer for machines, written the same way by every command.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace searig::app {

/// Writes the answer to a file, or to stdout where path is "-". Numbers keep every digit; what is
/// not finite becomes null. Throws std::runtime_error where the file cannot be written.
void write_json(const nlohmann::json& answer, const std::string& path);

/// A command's answer in both its forms: say() for people, unless stdout is the machine's; answer()
/// as JSON to `path`, if it was asked for.
template <typename Say, typename Answer>
void give(const std::string& path, Say say, Answer answer) {
  if (path != "-") say();
  if (!path.empty()) write_json(answer(), path);
}

}  // namespace searig::app
