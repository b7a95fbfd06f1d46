#include "estimator/model/predict.h"

#include <algorithm>
#include <cmath>

#include "estimator/physics/catalogue.h"
#include "estimator/physics/observation.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

Eigen::VectorXd contribution(const Effect& effect, const Term& term, const Model& model,
                             const Motion& motion) {
  const auto shape = effect.shape(term);
  return effect.features(motion, shape) * effect.amplitudes(term, model);
}

/// The sum of all of the model's terms in one path; terms that lack their channel count as absent.
Eigen::VectorXd sum_of(const Model& model, Path path, const Motion& motion) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(Eigen::Index(motion.size()));
  for (const auto& term : model.terms) {
    const Effect* effect = find_effect(term.effect);
    if (effect && effect->path() == path && effect->applies(motion))
      sum += contribution(*effect, term, model, motion);
  }
  return sum;
}

std::vector<double> to_std(const Eigen::VectorXd& x) {
  return {x.begin(), x.end()};
}

Motion motion_for(const Model& model, const ModuleSignals& module) {
  Motion motion = motion_of(module, differentiator_half_width_s);
  motion.smoothing_rad_s = model.get("drive.coulomb", "smoothing_rad_s").value_or(0.01);
  return motion;
}

/// History-dependent softening needs the torque itself: k*theta first, then the whole sum.
void add_spring_torque(const Model& model, Motion& motion) {
  const double k = scale_of(RelativeTo::stiffness, model);
  motion.spring_nm = to_std(k * as_array(motion.theta).matrix());
  motion.spring_nm = to_std(sum_of(model, Path::spring, motion));
}

}  // namespace

Torques predict(const Model& model, const ModuleSignals& module) {
  Motion motion = motion_for(model, module);
  Torques out;
  if (motion.has_spring()) {
    add_spring_torque(model, motion);
    out.spring_nm = motion.spring_nm;
    const Eigen::VectorXd rig = sum_of(model, Path::rig, motion);
    out.rig_nm = to_std(-rig);
    Eigen::VectorXd seen = as_array(out.spring_nm).matrix() + rig;
    for (const auto& term : model.terms)
      if (const auto* observation = dynamic_cast<const Observation*>(find_effect(term.effect)))
        seen = observation->seen(motion.t, seen, observation->shape(term)[0]);
    out.loadcell_nm = to_std(seen);
  }
  if (motion.has_drive()) out.drive_nm = to_std(sum_of(model, Path::drive, motion));
  return out;
}

std::vector<double> predict_drive(const Model& model, const ModuleSignals& module) {
  const bool needs_load = model.has("drive.load_friction");
  ModuleSignals drive = module;
  if (!needs_load) drive.deflection_rad.clear(), drive.output_angle_rad.clear();
  if (!drive.input_angle_rad.empty()) drive.input_velocity_rad_s.clear();
  Motion motion = motion_for(model, drive);
  if (needs_load && motion.has_spring()) add_spring_torque(model, motion);
  if (!motion.has_drive()) return {};
  return to_std(sum_of(model, Path::drive, motion));
}

std::vector<double> current_for(const Model& model, ModuleSignals module,
                                const std::vector<double>& spring_nm) {
  const auto drive_at = [&](double current_a) {
    module.current_a.assign(module.t_s.size(), current_a);
    return predict(model, module).drive_nm;
  };
  const auto at_none = drive_at(0.0), at_one = drive_at(1.0);
  std::vector<double> out(at_none.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = (spring_nm[i] - at_none[i]) / (at_one[i] - at_none[i]);
  }
  const bool sound = std::ranges::all_of(out, [](double x) { return std::isfinite(x); });
  return sound ? out : std::vector<double>();
}

std::vector<double> sample_at(const std::vector<double>& t, const std::vector<double>& x,
                              const std::vector<double>& at) {
  std::vector<double> out(at.size());
  if (t.empty()) return out;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto after = std::ranges::upper_bound(t, at[i]);
    if (after == t.begin()) {
      out[i] = x.front();
    } else if (after == t.end()) {
      out[i] = x.back();
    } else {
      const auto j = std::size_t(after - t.begin());
      const double u = (at[i] - t[j - 1]) / (t[j] - t[j - 1]);
      out[i] = u == 0.0 ? x[j - 1] : x[j - 1] + u * (x[j] - x[j - 1]);
    }
  }
  return out;
}

}  // namespace searig::estimator
