#include "acquisition/source/child_process.h"

#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

extern char** environ;

namespace searig::acquisition {
namespace {

constexpr int kPatience = 200;  // hundredths of a second for a child to end by itself

std::runtime_error cannot_start(const std::filesystem::path& program, int error) {
  return std::runtime_error(program.string() + " cannot be started: " + std::strerror(error) + ".");
}

/// The other end becomes the child's standard input and output.
int spawn(const std::filesystem::path& program, std::vector<std::string> words, int other_end,
          pid_t& id) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, other_end, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, other_end, STDOUT_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int error =
      posix_spawn(&id, program.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments) {
  // A socket, as writing to one whose other end is gone can be kept from killing the writer.
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw cannot_start(program, errno);
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const int error = spawn(program, std::move(words), ends[1], id_);
  close(ends[1]);
  line_ = ends[0];
  if (error == 0) return;
  close(line_);
  throw cannot_start(program, error);
}

void ChildProcess::say(const std::string& line) {
  const std::string words = line + "\n";
  // A line is far shorter than what a socket takes at once.
  (void)send(line_, words.data(), words.size(), MSG_NOSIGNAL);
}

std::string ChildProcess::hear() {
  std::array<char, 512> buffer;
  std::size_t end;
  while ((end = heard_.find('\n')) == std::string::npos) {
    const ssize_t count = recv(line_, buffer.data(), buffer.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return {};
    heard_.append(buffer.data(), static_cast<std::size_t>(count));
  }
  const std::string line = heard_.substr(0, end);
  heard_.erase(0, end + 1);
  return line;
}

int ChildProcess::end() {
  if (id_ < 0) return -1;
  close(std::exchange(line_, -1));
  const pid_t id = std::exchange(id_, -1);
  int status = 0;
  for (int i = 0; i < kPatience; ++i) {
    if (waitpid(id, &status, WNOHANG) == id) return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    usleep(10'000);
  }
  kill(id, SIGKILL);
  waitpid(id, &status, 0);
  return -1;
}

std::filesystem::path program_beside(const std::string& name) {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
}

}  // namespace searig::acquisition
