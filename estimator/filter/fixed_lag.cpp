#include "estimator/filter/fixed_lag.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "estimator/kinematics.h"

namespace searig::estimator {

FixedLag::FixedLag(double half_width_s, std::size_t capacity)
    : half_width_(half_width_s), capacity_(capacity) {
  if (!(half_width_s >= 0) || capacity < 20) {
    throw std::invalid_argument("a fixed lag needs a half width of at least 0 s and 20 samples");
  }
  for (auto* channel : {&t_, &x_, &drive_}) channel->reserve(capacity);
}

bool FixedLag::push(const Sample& s) {
  const bool finite = std::isfinite(s.t) && std::isfinite(s.deflection) && std::isfinite(s.drive);
  if (!finite || (!t_.empty() && s.t <= t_.back())) return false;
  if (t_.size() == capacity_) forget();
  t_.push_back(s.t);
  x_.push_back(s.deflection);
  drive_.push_back(s.drive);
  return true;
}

std::optional<FixedLag::Rated> FixedLag::next() {
  std::size_t from = 0, to = 0;
  if (!complete(from, to)) return std::nullopt;
  const std::size_t i = centre_++;
  const std::span<const double> t(t_), x(x_);
  const auto d = local_cubic(t.subspan(from, to - from), x.subspan(from, to - from), t_[i]);
  return Rated{{t_[i], x_[i], drive_[i]}, d.value, d.first};
}

// The window about the centre, once the sample after it has been seen: what comes later
// has no say in it.
bool FixedLag::complete(std::size_t& from, std::size_t& to) const {
  if (centre_ >= t_.size()) return false;
  const Window window = window_about(t_, centre_, half_width_);
  from = window.from, to = window.to;
  const bool no_room_to_wait = t_.size() == capacity_ && centre_ <= kept_before_centre();
  return to < t_.size() || no_room_to_wait;
}

// Drops what lies so far back that no window needs it.
void FixedLag::forget() {
  const std::size_t keep = kept_before_centre();
  const std::size_t drop = centre_ > keep ? centre_ - keep : 1;
  for (auto* channel : {&t_, &x_, &drive_})
    channel->erase(channel->begin(), channel->begin() + drop);
  centre_ -= std::min(centre_, drop);
}

}  // namespace searig::estimator
