// searig record on the simulated rig, running until a test ends it.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <map>
#include <random>
#include <thread>
#include <vector>

#include "acquisition/recording/recording.h"
#include "acquisition/source/source.h"
#include "tests/system/run_program.h"

namespace searig {

inline std::string record(const std::filesystem::path& out, const std::string& more) {
  return "searig record --loadcell sim: --module sim: --out " + out.string() + " " + more;
}

/// The program running, to be ended by the test.
class Running {
 public:
  explicit Running(const std::vector<std::string>& words) {
    child_ = fork();
    if (child_ != 0) return;
    const int nothing = open("/dev/null", O_RDWR);
    for (const int stream : {0, 1, 2}) dup2(nothing, stream);
    close_range(3, ~0U, 0);  // nothing of the test's, least of all the pipes of its other processes
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  pid_t id() const { return child_; }
  int end(int signal) {
    kill(child_, signal);
    return wait();
  }
  int wait() {
    int status = 0;
    waitpid(child_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t child_ = -1;
};

inline std::vector<std::string> recording_words(const std::filesystem::path& out) {
  return {std::string(SEARIG_BINARY_DIR) + "/searig",
          "record",
          "--loadcell",
          "sim:",
          "--module",
          "sim:",
          "--out",
          out.string()};
}

inline void sleep_s(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// Every row of one has its like in another recording of the same motion, which the devices begin
/// anew each time: the same frame says the same. same_time_s: how far the two may be apart, as the
/// firmware's clock is read between its interrupts.
inline void expect_same_rows(const acquisition::Stream& part, const acquisition::Stream& whole,
                             double same_time_s) {
  std::map<double, std::size_t> row_of;
  for (std::size_t row = 0; row < whole.t_s.size(); ++row) row_of[whole.channel("seq")[row]] = row;
  std::size_t compared = 0;
  for (std::size_t row = 0; row < part.t_s.size(); ++row) {
    const auto found = row_of.find(part.channel("seq")[row]);
    if (found == row_of.end()) continue;  // before or after the other was listened to
    if (std::abs(part.t_s[row] - whole.t_s[found->second]) > same_time_s) continue;
    ++compared;
    for (const acquisition::Channel& channel : part.channels)
      ASSERT_EQ(channel.values[row], whole.channel(channel.name)[found->second])
          << part.name << " " << channel.name << " of row " << row;
  }
  EXPECT_GT(compared, part.t_s.size() * 9 / 10) << part.name;
}

/// Rows follow each other without a gap: what is lost is lost at the end only.
inline void expect_no_hole(const acquisition::Stream& stream) {
  const auto& seq = stream.channel("seq");
  for (std::size_t row = 1; row < seq.size(); ++row) ASSERT_EQ(seq[row], seq[row - 1] + 1.0);
}

/// Devices take a moment to start, on a busy machine a long one: then both have been heard.
inline void wait_until_recording(const std::filesystem::path& file) {
  std::error_code not_there_yet;
  for (int i = 0; i < 1000; ++i, sleep_s(0.02)) {
    const auto size = std::filesystem::file_size(file, not_there_yet);
    if (!not_there_yet && size > 60'000) return;
  }
  FAIL() << file << " does not grow";
}

/// Kills recordings at random instants; returns the longest time that was lost, s.
inline double worst_loss_of_kills(int kills, double longest_s) {
  const TemporaryFolder folder;
  const std::filesystem::path whole_file = folder.path() / "whole.mcap";
  const Ran whole_run =
      run_program(record(whole_file, "--seconds " + std::to_string(longest_s + 2.0)));
  EXPECT_EQ(whole_run.exit_code, 0) << whole_run.err;
  const acquisition::Recording whole = acquisition::read_recording(whole_file);

  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> instant(0.1, longest_s);
  double worst_s = 0.0;
  for (int i = 0; i < kills; ++i) {
    const std::filesystem::path file = folder.path() / (std::to_string(i) + ".mcap");
    Running running(recording_words(file));
    wait_until_recording(file);
    sleep_s(instant(random));
    const double killed_s = acquisition::host_now_s();
    running.end(SIGKILL);
    const acquisition::Recording read = acquisition::read_recording(file);
    expect_same_rows(read.module, whole.module, 0.0);
    expect_same_rows(read.loadcell, whole.loadcell, 1e-4);
    expect_no_hole(read.module);
    expect_no_hole(read.loadcell);
    EXPECT_NE(read.cut_off, "");
    worst_s = std::max(worst_s, killed_s - read.module.host_s.back());
    std::filesystem::remove(file);
  }
  return worst_s;
}

}  // namespace searig
