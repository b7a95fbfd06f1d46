#include "app/cli/desktop_program.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

extern char** environ;

namespace searig::app {
namespace {

/// What exec and spawn want: pointers into strings that outlive them, and a null at the end.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> command_line(const std::filesystem::path& program,
                                      const std::vector<std::string>& arguments) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

std::runtime_error cannot_start(const std::filesystem::path& program, int error) {
  return std::runtime_error(program.string() + " cannot be started: " + std::strerror(error) + ".");
}

}  // namespace

std::filesystem::path find_desktop_program() {
  const auto self = std::filesystem::read_symlink("/proc/self/exe");
  const auto program = self.parent_path() / "searig-desktop";
  if (!std::filesystem::exists(program)) {
    throw std::runtime_error("The desktop app is not there (" + program.string() +
                             "); build it with Qt 5 and Qwt installed.");
  }
  return program;
}

void become(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  auto words = command_line(program, arguments);
  const auto argv = pointers_to(words);
  execv(program.c_str(), argv.data());
  throw cannot_start(program, errno);
}

int run_to_end(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  auto words = command_line(program, arguments);
  const auto argv = pointers_to(words);
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), nullptr, nullptr, argv.data(), environ);
  if (error != 0) throw cannot_start(program, error);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

bool has_display() {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  return set("DISPLAY") || set("WAYLAND_DISPLAY");
}

}  // namespace searig::app
