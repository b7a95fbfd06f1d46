#include "acquisition/clock/velocity_likeness.h"

#include <algorithm>
#include <cmath>

#include "acquisition/clock/device_clock.h"

namespace searig::acquisition {

Binned binned(std::span<const double> t, std::span<const double> v, double width_s) {
  const double step = median_step(t);  // a sample stands for the time around it
  Binned out{t.front() - 0.5 * step, width_s, {}};
  const auto bins = std::size_t(std::max(1.0, (t.back() - out.start_s) / width_s));
  std::vector<double> sum(bins, 0.0), count(bins, 0.0);
  for (std::size_t i = 0; i < t.size(); ++i) {
    const auto bin = std::min(bins - 1, std::size_t((t[i] - out.start_s) / out.width_s));
    sum[bin] += v[i], count[bin] += 1.0;
  }
  for (std::size_t i = 0; i < bins; ++i)
    out.velocity.push_back(count[i] > 0 ? sum[i] / count[i] : i > 0 ? out.velocity[i - 1] : 0.0);
  return out;
}

std::vector<double> derivative(const Binned& reference, std::span<const double> device_s,
                               std::span<const double> angle, const Laid& laid) {
  const double rate = (laid.last_s - laid.first_s) / (device_s.back() - device_s.front());
  std::size_t row = 0;
  const auto angle_at = [&](double t) {
    const double own = device_s.front() + (t - laid.first_s) / rate;
    if (own <= device_s.front()) return angle.front();
    if (own >= device_s.back()) return angle.back();
    while (device_s[row + 1] < own) ++row;
    const double u = (own - device_s[row]) / (device_s[row + 1] - device_s[row]);
    return angle[row] + u * (angle[row + 1] - angle[row]);
  };
  std::vector<double> out(reference.velocity.size());
  double before = angle_at(reference.start_s);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double after = angle_at(reference.start_s + double(i + 1) * reference.width_s);
    out[i] = (after - before) / reference.width_s;
    before = after;
  }
  return out;
}

Likeness likeness(const std::vector<double>& y, const std::vector<double>& x) {
  const double n = double(y.size());
  double sx = 0, sy = 0;
  for (std::size_t i = 0; i < y.size(); ++i) sx += x[i], sy += y[i];
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double dx = x[i] - sx / n, dy = y[i] - sy / n;
    xx += dx * dx, xy += dx * dy, yy += dy * dy;
  }
  Likeness out;
  out.sse = yy;
  if (!(xx > 0) || !(yy > 0)) return out;
  out.correlation = xy / std::sqrt(xx * yy);
  out.gain = std::max(0.0, xy / xx);
  out.bias = (sy - out.gain * sx) / n;
  out.sse = yy - out.gain * xy;
  return out;
}

std::vector<double> left_over(const std::vector<double>& y, const std::vector<double>& x,
                              const Likeness& fit) {
  std::vector<double> out(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) out[i] = y[i] - fit.gain * x[i] - fit.bias;
  return out;
}

double correlated(const std::vector<double>& noise) {
  double variance = 0.0;
  for (const double e : noise) variance += e * e;
  double sum = 1.0;
  for (std::size_t lag = 1; variance > 0 && lag < noise.size() / 10; ++lag) {
    double product = 0.0;
    for (std::size_t i = lag; i < noise.size(); ++i) product += noise[i] * noise[i - lag];
    if (product < 0.05 * variance) break;
    sum += 2.0 * product / variance;
  }
  return sum;
}

}  // namespace searig::acquisition
