#include "estimator/diagnosis/search/atom_collector.h"

#include <algorithm>
#include <cmath>

#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

std::pair<double, double> range(const std::vector<double>& x) {
  const auto [low, high] = std::ranges::minmax_element(x);
  return {*low, *high};
}

}  // namespace

void AtomCollector::add(std::string what, Path path, std::string channel, double from, double to,
                        const Array& feature, Make at) {
  if (feature.size() == 0 || !feature.allFinite() || feature.abs().maxCoeff() <= 0) return;
  out_.push_back({std::move(what), path, std::move(channel), from, to, false, feature.matrix(),
                  std::move(at)});
}

void AtomCollector::add(std::string what, Path path, std::string channel, double from, double to,
                        const Make& at) {
  add(std::move(what), path, std::move(channel), from, to, at(from, to).array(), at);
}

void AtomCollector::bumps(const std::vector<double>& x, const std::string& channel, Path path,
                          int count, const Array& carrier, const std::string& what) {
  if (x.empty()) return;
  const auto [low, high] = range(x);
  if (!(high > low)) return;
  for (const double width : {(high - low) / count, 0.35 * (high - low) / count})
    for (double c = low; c <= high; c += width)
      add(what, path, channel, c - width, c + width,
          [&x, carrier](double from, double to) -> Eigen::VectorXd {
            const double centre = 0.5 * (from + to), sd = 0.25 * (to - from);
            Array bump = (-0.5 * ((as_array(x) - centre) / sd).square()).exp();
            if (carrier.size() > 0) bump *= carrier;
            return bump.matrix();
          });
}

void AtomCollector::hinges(const std::vector<double>& x, const std::string& channel, Path path) {
  if (x.empty()) return;
  const auto [low, high] = range(x);
  for (const double share : {0.2, 0.4, 0.6, 0.75, 0.88, 0.94}) {
    const double up = high * share, down = low * share;
    add("something that begins beyond a value", path, channel, up, high,
        [&x](double from, double) -> Eigen::VectorXd {
          return (as_array(x) - from).max(0.0).matrix();
        });
    add("something that begins beyond a value", path, channel, low, down,
        [&x](double, double to) -> Eigen::VectorXd {
          return (as_array(x) - to).min(0.0).matrix();
        });
  }
}

void AtomCollector::waves(const std::vector<double>& angle, const std::string& channel, Path path,
                          int count, const Array& carrier, double first) {
  if (angle.empty()) return;
  const auto [low, high] = range(angle);
  if (!(high > low)) return;
  // Less than two thirds of a wave over the range is a constant or a slope, not a wave.
  first = std::max(first, 4.0 / (high - low));
  const double step = 0.5 * M_PI / (high - low);
  for (int i = 0; i < count; ++i)
    for (const bool cosine : {false, true}) {
      const Array x = (first + i * step) * as_array(angle);
      Array wave = (x + (cosine ? M_PI / 2 : 0.0)).sin();
      if (carrier.size() > 0) wave *= carrier;
      add("a wave over the angle", path, channel, low, high, wave);
    }
}

void AtomCollector::events(const std::string& what, Path path, const Array& carrier, int count) {
  const double end = m_.t.back();
  for (int i = 1; i < count; ++i) {
    const double at = end * (0.08 + 0.84 * i / count);
    add(what, path, "time_s", at, end,
        [&m = m_, carrier](double from, double to) -> Eigen::VectorXd {
          const auto t = as_array(m.t);
          return (t > from && t <= to).select(carrier, 0.0).matrix();
        });
    if (!out_.empty()) out_.back().at_once = true;
  }
}

void AtomCollector::episodes(Path path, int count, const Array& carrier) {
  const double end = m_.t.back();
  for (int i = 0; i < count; ++i)
    add("something that happens only for a while", path, "time_s", end * i / count,
        end * (i + 1) / count, [&m = m_, carrier](double from, double to) -> Eigen::VectorXd {
          const auto t = as_array(m.t);
          return (t > from && t <= to).select(carrier, 0.0).matrix();
        });
}

void AtomCollector::shaped(std::string what, Path path, std::string channel,
                           const std::vector<double>& x, const Array& feature) {
  if (x.empty()) return;
  const auto [low, high] = range(x);
  add(std::move(what), path, std::move(channel), low, high, feature);
}

}  // namespace searig::estimator
