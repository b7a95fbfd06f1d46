// A program run as a child, with what it cost.
#pragma once

#include <sys/types.h>
#include <functional>
#include <string>
#include <vector>

struct Cost {
  double wall_s = 0, cpu_s = 0, peak_mb = 0;
  int exit_code = -1;
};

/// Output goes nowhere. `meanwhile`, where given, is called with the child's id until it says true,
/// about a hundred times a second.
Cost run(const std::vector<std::string>& command, const std::function<bool(pid_t)>& meanwhile = {});
