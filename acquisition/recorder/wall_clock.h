// The hour, for people and other programs; nothing is measured by it.
#pragma once

#include <string>

namespace searig::acquisition {

/// Seconds since 1970, by a clock that may be set.
double unix_now_s();

/// "2026-11-22T01:05:03Z"
std::string utc(double unix_s);

}  // namespace searig::acquisition
