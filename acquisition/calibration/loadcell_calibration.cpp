#include "acquisition/calibration/loadcell_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "acquisition/error.h"

namespace searig::acquisition {
namespace {

/// Student's t, two-sided 95 %.
double student_t95(std::size_t degrees_of_freedom) {
  constexpr std::array<double, 10> few{12.706, 4.303, 3.182, 2.776, 2.571,
                                       2.447,  2.365, 2.306, 2.262, 2.228};
  if (degrees_of_freedom <= few.size()) return few[degrees_of_freedom - 1];
  const double n = double(degrees_of_freedom);
  return 1.95996 + 2.372 / n + 2.82 / (n * n);  // within 0.001 from 11 on
}

double mean(const std::vector<KnownWeight>& weights, double KnownWeight::*value) {
  double sum = 0.0;
  for (const KnownWeight& weight : weights) sum += weight.*value;
  return sum / double(weights.size());
}

/// How much of the residuals a parabola in the force takes away, N at the ends of the range.
double bend_n(const LoadcellCalibration& calibration) {
  const double middle = mean(calibration.weights, &KnownWeight::force_n);
  double reach = 0.0;
  for (const KnownWeight& w : calibration.weights)
    reach = std::max(reach, std::abs(w.force_n - middle));
  double square_mean = 0.0;
  for (const KnownWeight& w : calibration.weights)
    square_mean += std::pow((w.force_n - middle) / reach, 2) / double(calibration.weights.size());
  double up = 0.0, down = 0.0;
  for (std::size_t i = 0; i < calibration.weights.size(); ++i) {
    const double s = (calibration.weights[i].force_n - middle) / reach;
    up += (s * s - square_mean) * calibration.residuals_n[i];
    down += std::pow(s * s - square_mean, 2);
  }
  return down > 1e-9 ? up / down : 0.0;
}

}  // namespace

LoadcellCalibration calibrate(std::vector<KnownWeight> weights) {
  const std::size_t n = weights.size();
  if (n < 3) throw InputError("A calibration needs at least three readings.");
  const double f_mean = mean(weights, &KnownWeight::force_n);
  const double c_mean = mean(weights, &KnownWeight::counts);
  double ff = 0.0, fc = 0.0;
  for (const KnownWeight& w : weights) {
    ff += (w.force_n - f_mean) * (w.force_n - f_mean);
    fc += (w.force_n - f_mean) * (w.counts - c_mean);
  }
  if (!(ff > 0.0)) throw InputError("All readings are under one force; a calibration needs two.");
  const double slope = fc / ff;  // counts per newton
  if (slope == 0.0 || !std::isfinite(slope))
    throw InputError("The counts do not depend on the force; is the load cell connected?");

  LoadcellCalibration out;
  out.tare_counts = c_mean - slope * f_mean;
  out.newton_per_count = 1.0 / slope;
  double squares = 0.0;
  for (const KnownWeight& w : weights) {
    out.residuals_n.push_back(out.force_n(w.counts) - w.force_n);
    squares += std::pow(w.counts - (out.tare_counts + slope * w.force_n), 2);
  }
  const double sd_counts = std::sqrt(squares / double(n - 2));
  const double t = student_t95(n - 2);
  out.residual_sd_n = sd_counts * std::abs(out.newton_per_count);
  out.tare_ci95_counts = t * sd_counts * std::sqrt(1.0 / double(n) + f_mean * f_mean / ff);
  out.newton_per_count_ci95 =
      t * sd_counts / std::sqrt(ff) * out.newton_per_count * out.newton_per_count;
  out.weights = std::move(weights);
  return out;
}

std::vector<std::string> doubts(const LoadcellCalibration& calibration) {
  std::vector<std::string> sentences;
  char text[200];
  const auto& weights = calibration.weights;
  const double sd = calibration.residual_sd_n;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights.size() < 5 || std::abs(calibration.residuals_n[i]) < 2.5 * sd) continue;
    std::snprintf(text, sizeof text,
                  "the reading %.9g under %.6g N lies %.3g N off the line; the others scatter by "
                  "%.3g N",
                  weights[i].counts, weights[i].force_n, calibration.residuals_n[i], sd);
    sentences.push_back(text);
  }
  const double bend = bend_n(calibration);
  if (weights.size() >= 4 && std::abs(bend) > 2.0 * sd) {
    std::snprintf(text, sizeof text, "the line is bent by %.3g N between the ends and the middle",
                  bend);
    sentences.push_back(text);
  }
  if (sd == 0.0)
    sentences.push_back("the readings lie on the line to the last count: were they measured?");
  return sentences;
}

std::string describe(const LoadcellCalibration& calibration) {
  char text[240];
  std::snprintf(
      text, sizeof text,
      "Load cell calibrated %s with %zu readings: %.6g N per count (+-%.2g %%), tare %.1f "
      "(+-%.1f) counts, scatter %.3g N, lever arm %.6g m",
      calibration.date.c_str(), calibration.weights.size(), calibration.newton_per_count,
      100.0 * std::abs(calibration.newton_per_count_ci95 / calibration.newton_per_count),
      calibration.tare_counts, calibration.tare_ci95_counts, calibration.residual_sd_n,
      calibration.lever_arm_m);
  return text;
}

}  // namespace searig::acquisition
