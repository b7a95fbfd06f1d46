#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class RigZeroDrift final : public SingleAmplitude {
 public:
  RigZeroDrift()
      : SingleAmplitude(
            {.name = "rig.zero_drift",
             .path = Path::rig,
             .title = "the load cell's zero drifts with time",
             .equation = "+ nm_per_min*t/60",
             .looks_like = "a straight line in time, at any load",
             .confused_with = "spring.relaxation with a long time, creep of the load cell",
             .separated_by = "no load for a few minutes",
             .channel = "time_s",
             .source = "load-cell zero drift, OIML R 60"},
            {{"nm_per_min", -unlimited, unlimited, "drift of the zero"}}) {}

  bool applies(const Motion& m) const override { return m.size() > 0; }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double>) const override {
    return (as_array(m.t) / 60.0).matrix();
  }
};

}  // namespace

const Effect& rig_zero_drift() {
  static const RigZeroDrift effect;
  return effect;
}

}  // namespace searig::estimator
