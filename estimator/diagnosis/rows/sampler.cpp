#include "estimator/diagnosis/rows/sampler.h"

#include <algorithm>
#include <stdexcept>

namespace searig::estimator {
namespace {

constexpr double slow = 1.2;  // windows from sample to sample: clearly more than one

}  // namespace

Sampler::Sampler(const std::vector<double>& t, const std::vector<double>& centres, double width_s,
                 double shift_s)
    : t_(Eigen::Map<const Eigen::VectorXd>(t.data(), Eigen::Index(t.size()))) {
  if (t.size() < 2) throw std::invalid_argument("a sampler needs two samples");
  curved_ = (t.back() - t.front()) / double(t.size() - 1) > slow * width_s;
  const auto place = [&](double at) {
    const auto after = std::ranges::upper_bound(t, at);
    const auto sample =
        std::clamp<std::ptrdiff_t>(after - t.begin() - 1, 0, std::ptrdiff_t(t.size()) - 2);
    return Place{sample, at - t[std::size_t(sample)]};
  };
  for (const double centre : centres) {
    const double from = centre + shift_s - width_s / 2, to = centre + shift_s + width_s / 2;
    begin_.push_back(place(from));
    end_.push_back(place(to));
    inside_.push_back(from >= t.front() && to <= t.back());
  }
}

std::vector<bool> Sampler::covered(double gap_s) const {
  std::vector<bool> out = inside_;
  for (std::size_t i = 0; i < out.size(); ++i)
    for (Eigen::Index j = begin_[i].sample; j <= end_[i].sample; ++j)
      if (t_[j + 1] - t_[j] > gap_s) out[i] = false;
  return out;
}

Sampler::Slopes Sampler::slopes(const Eigen::VectorXd& x) const {
  const Eigen::Index intervals = x.size() - 1;
  const Eigen::ArrayXd step = t_.tail(intervals) - t_.head(intervals);
  const Eigen::ArrayXd chord = (x.tail(intervals) - x.head(intervals)).array() / step;
  Slopes out(intervals, 2);
  out.col(0) = out.col(1) = chord;
  for (Eigen::Index i = 1; curved_ && i < intervals; ++i)  // of the parabola through three samples
    out(i - 1, 1) = out(i, 0) =
        (step[i] * chord[i - 1] + step[i - 1] * chord[i]) / (step[i - 1] + step[i]);
  return out;
}

double Sampler::integral_to(const Place& place, const Eigen::VectorXd& x, const Slopes& slope,
                            const Eigen::VectorXd& integral) const {
  const Eigen::Index i = place.sample;
  const double h = t_[i + 1] - t_[i], u = place.within_s / h, u2 = u * u, u3 = u2 * u, u4 = u2 * u2;
  return integral[i] +
         h * ((u - u3 + 0.5 * u4) * x[i] + (u3 - 0.5 * u4) * x[i + 1] +
              h * ((u2 / 2 - 2 * u3 / 3 + u4 / 4) * slope(i, 0) + (u4 / 4 - u3 / 3) * slope(i, 1)));
}

Eigen::VectorXd Sampler::operator()(const Eigen::VectorXd& x) const {
  const Slopes slope = slopes(x);
  Eigen::VectorXd integral(x.size());
  integral[0] = 0.0;
  for (Eigen::Index i = 1; i < x.size(); ++i) {
    const double h = t_[i] - t_[i - 1];
    integral[i] = integral[i - 1] + 0.5 * h * (x[i] + x[i - 1]) +
                  h * h * (slope(i - 1, 0) - slope(i - 1, 1)) / 12;
  }
  Eigen::VectorXd out(rows());
  for (Eigen::Index i = 0; i < rows(); ++i) {
    const Place &b = begin_[std::size_t(i)], &e = end_[std::size_t(i)];
    const double width = t_[e.sample] + e.within_s - t_[b.sample] - b.within_s;
    out[i] = (integral_to(e, x, slope, integral) - integral_to(b, x, slope, integral)) / width;
  }
  return out;
}

Eigen::MatrixXd Sampler::columns(const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd out(rows(), x.cols());
  for (Eigen::Index c = 0; c < x.cols(); ++c) out.col(c) = (*this)(x.col(c));
  return out;
}

}  // namespace searig::estimator
