// One line on stderr that says what is being done, where someone is there to read it.
#pragma once

#include <chrono>
#include <string>

namespace searig::app {

/// Silent where stderr is no terminal, and during the first second. Gone when the work is.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  static constexpr double no_end = -1.0;  ///< a share where nobody knows how long it takes

  void say(const std::string& doing, double share);

 private:
  std::chrono::steady_clock::time_point start_;
  bool terminal_;
  bool shown_ = false;
};

}  // namespace searig::app
