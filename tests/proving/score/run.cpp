#include "tests/proving/score/run.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <thread>

extern char** environ;

namespace searig::proving {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Standard error goes to a file; the exit status comes back, 124 when the time is up.
int execute(const std::vector<std::string>& command, const fs::path& errors) {
  std::vector<char*> arguments;
  for (const auto& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, errors.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, arguments[0], &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) return 127;
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Run run_one(const Tool& tool, const fs::path& recording, const fs::path& out) {
  std::vector<std::string> command{"timeout",          std::to_string(tool.timeout_s),
                                   tool.program,       "diagnose",
                                   recording.string(), "--json",
                                   out.string()};
  command.insert(command.end(), tool.extra_arguments.begin(), tool.extra_arguments.end());
  const fs::path errors = out.string() + ".err";
  const auto start = std::chrono::steady_clock::now();
  const int status = execute(command, errors);
  Run run;
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (status == 124) return {nullptr, "timeout", run.seconds};
  if (status != 0) {
    const std::string said = contents(errors);
    run.error = "exit " + std::to_string(status) + ": " +
                said.substr(said.size() > 160 ? said.size() - 160 : 0);
    return run;
  }
  run.answer = nlohmann::json::parse(contents(out), nullptr, false);
  if (run.answer.is_discarded()) run = {nullptr, "its answer is not JSON", run.seconds};
  return run;
}

}  // namespace

Runs run_all(const Tool& tool, const fs::path& recordings, const std::vector<std::string>& names,
             int jobs) {
  // The tool sees recordings and a scratch folder; the answers lie elsewhere and are not named.
  const fs::path scratch = fs::temp_directory_path() / ("searig-prove-" + std::to_string(getpid()));
  fs::create_directories(scratch);
  std::vector<Run> done(names.size());
  std::atomic<std::size_t> next{0}, finished{0};
  {
    std::vector<std::jthread> pool;
    for (int j = 0; j < jobs; ++j)
      pool.emplace_back([&] {
        for (std::size_t i = next++; i < names.size(); i = next++) {
          done[i] = run_one(tool, recordings / names[i], scratch / (names[i] + ".json"));
          if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\r%zu of %zu", ++finished, names.size());
        }
      });
  }
  fs::remove_all(scratch);
  Runs runs;
  for (std::size_t i = 0; i < names.size(); ++i) runs[names[i]] = done[i];
  return runs;
}

nlohmann::json to_json(const Runs& runs) {
  nlohmann::json out = nlohmann::json::object();
  for (const auto& [name, run] : runs)
    out[name] = {{"answer", run.answer}, {"error", run.error}, {"seconds", run.seconds}};
  return out;
}

Runs runs_from(const nlohmann::json& results) {
  Runs runs;
  const nlohmann::json& all = results.contains("results") ? results["results"] : results;
  for (const auto& [name, r] : all.items())
    runs[name] = {r.at("answer"), r.value("error", ""), r.value("seconds", 0.0)};
  return runs;
}

}  // namespace searig::proving
