// A device's own clock as it came in: counter wraps, restarts, rows doubled or out of their order.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace searig::acquisition {

/// What the rows of one stream say about the device clock. Nothing is invented: rows are put in
/// order of the device clock within each run between restarts, rows seen before are left out, and
/// every such row is counted.
struct ClockedRows {
  std::vector<std::size_t> order;     ///< received rows kept, in order of the device clock
  std::vector<double> t_s;            ///< device time of the rows kept, wraps undone
  std::vector<std::size_t> restarts;  ///< indices into `order` at which the clock began anew
  std::size_t doubled = 0;            ///< rows with the seq or the device time of another
  std::size_t out_of_order = 0;       ///< rows older than their predecessor
  std::size_t lost = 0;               ///< gaps in seq, or else in a device time that keeps a beat
  std::size_t astray = 0;             ///< rows left out: their time stands apart from all others
  std::size_t misplaced = 0;          ///< fewest rows to take out for the others to be in order
  std::size_t first_not_rising = 0;   ///< the first received row no younger than its predecessor
};

/// Reads a device clock of rows as received.
///
/// t_s: device time, s. host_s: arrival, s, or empty. seq: frame numbers, or empty; they may wrap
/// at 8, 16 or 32 bits.
///
/// A step back is, in this order:
/// - a wrap, where it is that of a 16- or 32-bit counter of milli- or microseconds (or the sign
///   bit of one) from its end to its beginning;
/// - a restart, where the clock goes on rising from below everything of the last rows before it,
///   and the host, if heard, did not step back;
/// - else a row out of order.
ClockedRows read_device_clock(std::span<const double> t_s, std::span<const double> host_s,
                              std::span<const double> seq);

/// The middle of a clock's steps forward, s; 0 where there are none.
double median_step(std::span<const double> t_s);

}  // namespace searig::acquisition
