// Included before everything else in the filter's tests: see CMakeLists.txt.
#pragma once

#include <stdexcept>

#define eigen_assert(condition)                           \
  do {                                                    \
    if (!(condition)) throw std::logic_error(#condition); \
  } while (false)
