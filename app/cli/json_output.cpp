#include "app/cli/json_output.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace searig::app {

void write_json(const nlohmann::json& answer, const std::string& path) {
  // File names may hold any bytes; one that is not UTF-8 must not lose the whole answer.
  const std::string text =
      answer.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
  if (path == "-") {
    std::cout << text << std::flush;
    return;
  }
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file) throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno) + ".");
}

}  // namespace searig::app
