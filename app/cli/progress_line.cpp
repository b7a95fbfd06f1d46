#include "app/cli/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace searig::app {

ProgressLine::ProgressLine()
    : start_(std::chrono::steady_clock::now()), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::say(const std::string& doing, double share) {
  if (!terminal_ || std::chrono::steady_clock::now() - start_ < std::chrono::seconds(1)) return;
  std::fputs("\r\033[K  ", stderr);
  if (share != no_end) std::fprintf(stderr, "%3.0f %%  ", 100.0 * share);
  std::fputs(doing.c_str(), stderr);
  std::fflush(stderr);
  shown_ = true;
}

}  // namespace searig::app
