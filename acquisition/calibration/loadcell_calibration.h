// A load cell's counts against known weights: a straight line with its uncertainty.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace searig::acquisition {

/// One reading under a known force.
struct KnownWeight {
  double force_n = 0.0;
  double counts = 0.0;
};

/// force_n = (counts - tare_counts) * newton_per_count
///
/// The sign of newton_per_count is the cell's polarity: negative where its counts fall as the known
/// force grows. The sign of the lever arm is how the cell is mounted: negative where a positive
/// torque of the spring pulls the other way.
struct LoadcellCalibration {
  double tare_counts = 0.0;
  double tare_ci95_counts = 0.0;  ///< half width
  double newton_per_count = 0.0;
  double newton_per_count_ci95 = 0.0;
  std::vector<KnownWeight> weights;  ///< what it was made from
  std::vector<double> residuals_n;   ///< what each reading says minus its known force
  double residual_sd_n = 0.0;        ///< on size - 2 degrees of freedom
  double lever_arm_m = 1.0;
  std::string date;  ///< "2026-11-22"

  double force_n(double counts) const { return (counts - tare_counts) * newton_per_count; }
};

/// Least squares of counts over force: the forces are known, the readings have the noise. The 95 %
/// intervals are Student's. Throws InputError with one sentence where there are fewer than three
/// readings, no two different forces, or counts that do not depend on the force.
LoadcellCalibration calibrate(std::vector<KnownWeight> weights);

/// What its maker should look at, one sentence each: a reading far from the line, a line that is
/// bent, readings that never differ.
std::vector<std::string> doubts(const LoadcellCalibration& calibration);

/// In one line for people.
std::string describe(const LoadcellCalibration& calibration);

/// "searig-calibration/1", with everything in it; the first line is describe() as a comment.
std::string to_toml(const LoadcellCalibration& calibration);

/// Throws InputError: `file`, line and key.
LoadcellCalibration parse_calibration(std::string_view toml, const std::string& file);

}  // namespace searig::acquisition
