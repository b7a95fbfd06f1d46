#include "app/reproduce/variant.h"

#include "estimator/twin/bench.h"
#include "estimator/twin/paper_module.h"

namespace searig::app::reproduce {
namespace {

using estimator::twin::measured_efficiency;

/// (2)  T_current = (tau I - J a) eta
estimator::Model drive(const estimator::twin::Parameters& module, double efficiency) {
  estimator::Model model;
  model.set("drive.motor", "torque_constant_nm_per_a", module.drive.torque_constant_nm_per_a);
  model.set("drive.motor", "efficiency", efficiency);
  model.set("drive.inertia", "j_kg_m2", module.drive.inertia_kg_m2);
  return model;
}

/// The straight line through two loads on the bench, load = eta*tau*I - friction: what the train
/// takes whatever the load, apart from what it takes of the load.
estimator::Model drive_with_friction(const estimator::twin::Parameters& module,
                                     const Protocol& protocol) {
  const double low_nm = protocol.bench_load_nm / 3.0, high_nm = protocol.bench_load_nm * 5.0 / 3.0;
  const double at_low_nm = low_nm / measured_efficiency(module, low_nm, protocol.bench_rad_s);
  const double at_high_nm = high_nm / measured_efficiency(module, high_nm, protocol.bench_rad_s);
  const double efficiency = (high_nm - low_nm) / (at_high_nm - at_low_nm);
  estimator::Model model = drive(module, efficiency);
  model.set("drive.coulomb", "torque_nm", efficiency * at_low_nm - low_nm);
  model.set("drive.coulomb", "smoothing_rad_s", 0.01);
  return model;
}

}  // namespace

std::vector<Variant> variants(const Protocol& protocol) {
  using estimator::DriveTerms;
  const auto module = estimator::twin::nominal_paper_module();
  const auto equation_2 =
      drive(module, measured_efficiency(module, protocol.bench_load_nm, protocol.bench_rad_s));
  return {{"paper", "Online, as the paper prints it", equation_2, DriveTerms::paper, true},
          {"searig", "Online, searig's numbers", equation_2, DriveTerms::paper, false},
          {"searig_friction", "Online, searig's numbers, friction known",
           drive_with_friction(module, protocol), DriveTerms::model, false},
          {"damping", "Online, linear, with equation (12)'s damping, friction known",
           drive_with_friction(module, protocol), DriveTerms::model, false,
           StateFilter{estimator::EstimatorKind::linear, {"spring.linear", "spring.viscous"}}}};
}

}  // namespace searig::app::reproduce
