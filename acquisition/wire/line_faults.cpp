#include "acquisition/wire/line_faults.h"

namespace searig::acquisition {

bool LineFaults::happens(double share) {
  return share > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < share;
}

std::vector<std::uint8_t> LineFaults::pass(std::span<const std::uint8_t> frame) {
  std::vector<std::uint8_t> out;
  if (happens(shares.drop)) {
    ++dropped_;
    return out;
  }
  out.assign(frame.begin(), frame.end());
  if (happens(shares.duplicate)) {
    ++duplicated_;
    out.insert(out.end(), frame.begin(), frame.end());
  }
  bool whole = true;
  for (std::uint8_t& byte : out) {
    for (int bit = 0; bit < 8 && shares.flip > 0.0; ++bit) {
      if (!happens(shares.flip)) continue;
      byte = static_cast<std::uint8_t>(byte ^ (1 << bit));
      whole = false;
    }
  }
  damaged_ += !whole;
  return out;
}

}  // namespace searig::acquisition
