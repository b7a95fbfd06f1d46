// A program that runs beside this one and is talked to line by line; it ends when this one does.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace searig::acquisition {

class ChildProcess {
 public:
  /// Starts it with its standard input and output on a line to here, in a process group of its own,
  /// so that Ctrl-C is for this program alone. The child is to end when its standard input does,
  /// which it also does when this program is killed. Throws std::runtime_error with one sentence.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  ~ChildProcess() { end(); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Says a line to it. What a child that has ended does not hear is gone.
  void say(const std::string& line);

  /// The next line that it says, without its end; empty where it has ended.
  std::string hear();

  /// Ends it and waits for that; its exit code, or -1.
  int end();

 private:
  pid_t id_ = -1;
  int line_ = -1;
  std::string heard_;
};

/// A program that is built and installed beside this one.
std::filesystem::path program_beside(const std::string& name);

}  // namespace searig::acquisition
