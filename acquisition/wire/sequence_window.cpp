#include "acquisition/wire/sequence_window.h"

namespace searig::acquisition {

SequenceWindow::Place SequenceWindow::place(std::uint32_t sequence) const {
  if (sequence >= next_) return Place::newest;
  const std::uint32_t behind = next_ - 1 - sequence;
  if (behind >= kLate) return Place::too_old;
  return (seen_ >> behind & 1) != 0 ? Place::seen : Place::late;
}

void SequenceWindow::mark(std::uint32_t sequence) {
  if (sequence < next_) {
    seen_ |= std::uint64_t{1} << (next_ - 1 - sequence);
    return;
  }
  const std::uint32_t step = sequence - next_ + 1;
  seen_ = step >= kLate ? 0 : seen_ << step;
  seen_ |= 1;
  next_ = sequence + 1;
}

void SequenceWindow::begin(std::uint32_t next) {
  next_ = next;
  seen_ = ~std::uint64_t{0};
}

}  // namespace searig::acquisition
