// What has been seen of a rising sequence: lost, late, seen before (as RFC 4303's replay window).
#pragma once

#include <cstdint>

namespace searig::acquisition {

class SequenceWindow {
 public:
  static constexpr std::uint32_t kLate = 64;  ///< how far behind the newest a frame may still come

  enum class Place : std::uint8_t {
    newest,   ///< after everything seen
    late,     ///< before the newest, and not seen yet
    seen,     ///< seen before
    too_old,  ///< so far behind the newest that it cannot be told whether it was seen
  };

  /// Where this number stands; changes nothing.
  Place place(std::uint32_t sequence) const;

  /// How many numbers are left out between the newest seen and this one, which is newer.
  std::uint32_t skipped(std::uint32_t sequence) const { return sequence - next_; }

  /// Marks as seen.
  void mark(std::uint32_t sequence);

  /// The number that would follow without a loss.
  std::uint32_t next() const { return next_; }

  /// Begins with this number as the one to come; nothing before it is known.
  void begin(std::uint32_t next);

 private:
  std::uint32_t next_ = 0;
  std::uint64_t seen_ = ~std::uint64_t{0};  ///< bit i: next_ - 1 - i was seen, or is not waited for
};

}  // namespace searig::acquisition
