// A small diagnosis made by hand, with something in every place.
#pragma once

#include <cmath>

#include "app/report/diagnosis_plots.h"

namespace searig::app {

inline Examined sample_diagnosis() {
  using namespace estimator;
  Examined out;
  out.parts = {{"first", 100.0, 110.0}};
  auto& module = out.signals.module;
  for (int i = 0; i <= 1000; ++i) {
    const double t = 100.0 + 0.01 * i;
    module.t_s.push_back(t);
    module.deflection_rad.push_back(0.1 * std::sin(2.0 * t));
  }
  Model given;
  given.set("spring.linear", "k_nm_per_rad", 42.0);
  out.given = given;

  Diagnosis& d = out.diagnosis;
  d.verdict = Verdict::missing_physics;
  Finding f;
  f.effect = "spring.viscous";
  f.probability = 0.93;
  f.alternatives = {{"rig.delay", 0.04, "a sharp knock on the lever"}, {"", 0.02, ""}};
  f.parameters = {{"spring.viscous", "c_nm_s_per_rad", 0.45, 0.43, 0.47}};
  f.located = {{"loadcell-spring"}, 0.8, {{"deflection_rate_rad_s", 0.1, 0.9}}, {{102.0, 104.0}}};
  f.before_nm = 0.06, f.after_nm = 0.01;
  f.next_experiment = "the same motion at several speeds";
  d.findings = {f};
  d.unexplained =
      Unexplained{{{"loadcell-spring"}, 0.1, {{"time_s", 103.0, 104.0}}, {}}, 0.001, "a knock"};
  d.spring = PathErrors{0.21, 0.06, 0.01, 0.009};
  d.undecidable = {{{"spring.cubic"}, "the deflection is small", "larger deflections"}};
  d.numbers = {{"spring.linear", "k_nm_per_rad", 40.0, 39.5, 40.5}};
  d.notes = {"no drive path: no current with a velocity"};
  d.extended = given;
  d.extended.set("spring.viscous", "c_nm_s_per_rad", 0.45);
  for (int i = 0; i < 500; ++i) {
    const double t = 100.0 + 0.02 * i;
    d.traces.t_s.push_back(t);
    d.traces.measured_nm.push_back(4.0 * std::sin(2.0 * t));
    d.traces.spring_before_nm.push_back(0.08 * std::cos(2.0 * t));
    d.traces.spring_after_nm.push_back(0.01 * std::cos(40.0 * t));
  }
  d.map = {{"loadcell-spring", {"deflection_rad", -0.1, 0.0}, 7.0, 0.5},
           {"loadcell-spring", {"deflection_rad", -0.1, 0.0}, -7.0, -0.5},
           {"loadcell-spring", {"deflection_rad", 0.0, 0.1}, 7.0, 0.5},
           {"loadcell-spring", {"deflection_rad", 0.0, 0.1}, -7.0, -0.5}};
  return out;
}

}  // namespace searig::app
