// The simulated devices as processes of their own, as a user runs them; they end with the test.
#pragma once

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

extern char** environ;

namespace searig {

/// A program of the build folder with pipes to its standard input and output.
class Process {
 public:
  explicit Process(std::vector<std::string> arguments) {
    int in[2], out[2];
    if (pipe(in) != 0 || pipe(out) != 0) throw std::runtime_error("no pipe");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    for (const int end : {in[0], in[1], out[0], out[1]}) {
      posix_spawn_file_actions_addclose(&actions, end);
    }
    arguments.front() = std::string(SEARIG_BINARY_DIR) + "/" + arguments.front();
    std::vector<char*> words;
    for (std::string& word : arguments) words.push_back(word.data());
    words.push_back(nullptr);
    const int error = posix_spawn(&id_, words[0], &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(in[0]);
    close(out[1]);
    to_ = fdopen(in[1], "w");
    from_ = fdopen(out[0], "r");
    if (error != 0) throw std::runtime_error("cannot start " + arguments.front());
  }
  ~Process() { end(); }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// The next line that it says, without its end.
  std::string line() {
    char text[512] = "";
    if (std::fgets(text, sizeof text, from_) == nullptr) return {};
    std::string said(text);
    if (said.ends_with('\n')) said.pop_back();
    return said;
  }

  /// Says a line to it; its answer.
  std::string command(const std::string& text) {
    std::fprintf(to_, "%s\n", text.c_str());
    std::fflush(to_);
    return line();
  }

  /// Closes its standard input, upon which it ends; its exit code.
  int end() {
    if (to_ == nullptr) return 0;
    std::fclose(to_);
    int status = 0;
    waitpid(id_, &status, 0);
    std::fclose(from_);
    to_ = from_ = nullptr;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t id_ = -1;
  std::FILE* to_ = nullptr;
  std::FILE* from_ = nullptr;
};

/// The board with a load cell, on a terminal under `link`.
class BoardProcess : public Process {
 public:
  explicit BoardProcess(const std::string& link, std::vector<std::string> options = {})
      : Process(with(link, std::move(options))), path(line()) {}
  const std::string path;

 private:
  static std::vector<std::string> with(const std::string& link, std::vector<std::string> options) {
    options.insert(options.begin(), {"searig-board", "--with-stdin", "--link", link});
    return options;
  }
};

/// The simulated module; `name` is what opens it.
class ModuleProcess : public Process {
 public:
  explicit ModuleProcess(std::vector<std::string> options = {})
      : Process(with(std::move(options))), name(line()) {}
  const std::string name;

 private:
  static std::vector<std::string> with(std::vector<std::string> options) {
    options.insert(options.begin(), {"searig-module", "--with-stdin", "--port", "0"});
    return options;
  }
};

}  // namespace searig
