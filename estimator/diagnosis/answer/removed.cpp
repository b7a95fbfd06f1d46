#include "estimator/diagnosis/answer/removed.h"

#include <algorithm>

namespace searig::estimator {
namespace {

double share_removed(double before, double after, double floor) {
  return std::clamp(
      (before * before - after * after) / std::max(1e-30, before * before - floor * floor), 0.0,
      1.0);
}

Removed removed_from(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                     const std::optional<PathErrors>& path) {
  if (!path) return {};
  const double b = rms_of(before), a = rms_of(after);
  return {b, a, share_removed(b, a, std::min(path->after, path->noise_floor))};
}

}  // namespace

Removed removed(const PathResiduals& before, const PathResiduals& after, Path path,
                const Diagnosis& out) {
  const Removed spring = removed_from(before.spring, after.spring, out.spring);
  const Removed drive = removed_from(before.drive, after.drive, out.drive);
  if (path == Path::drive || !out.spring) return drive;
  if (path == Path::spring || !out.drive) return spring;
  return drive.share > spring.share ? drive : spring;
}

}  // namespace searig::estimator
