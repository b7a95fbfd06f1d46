#include <algorithm>
#include <cmath>

#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

/// What "loading history" means. The third is Ogden and Roxburgh's: softer on every way back below
/// the largest load so far, and as it was before on the way beyond it.
enum History { work_done = 0, largest_deflection = 1, below_largest_load = 2 };

class SpringMullins final : public SingleAmplitude {
 public:
  SpringMullins()
      : SingleAmplitude(
            {.name = "spring.mullins",
             .path = Path::spring,
             .title = "the rubber softens with the loading it has seen",
             .equation = "k*theta*(1 - share*(1 - exp(-history/scale)))",
             .looks_like = "the slope falls over the recording, fast at first, and stays low",
             .confused_with = "spring.temperature, spring.relaxation with a long time; spring.cubic "
                              "once the largest load is past",
             .separated_by = "the same cycles again after a rest at constant temperature; cycles "
                             "that grow",
             .channel = "time_s",
             .source = "paper, Fig. 3; R. Ogden, D. Roxburgh, Proc. R. Soc. A 455, 1999"},
            {{"share", 0, 1, "largest loss of stiffness"},
             {"scale", 1e-9, unlimited, "history that brings 63 % of it: N*m*rad, or rad"},
             {"history", 0, 2,
              "0: work done while loading; 1: largest deflection so far; 2: work stored at the "
              "largest load so far over what is stored now",
              0.0}},
            RelativeTo::stiffness) {}

  bool applies(const Motion& m) const override { return m.has_spring() && !m.spring_nm.empty(); }

  std::vector<std::vector<double>> shape_grid(const Motion& m) const override {
    std::vector<std::vector<double>> out;
    for (const auto kind : {work_done, largest_deflection, below_largest_load}) {
      const double total = history(m, kind).maxCoeff();
      if (!(total > 0)) continue;
      for (const auto& scale : logarithmic_grid(0.02 * total, 1.5 * total, 6))
        out.push_back({scale[0], double(kind)});
    }
    return out;
  }

  std::size_t free_shape(std::span<const double>) const override { return 1; }

  bool physical(const Eigen::VectorXd& amplitude) const override { return amplitude[0] > 0; }

  /// A scale beyond the whole history would be a straight line of any slope.
  Range shape_range(const Motion& m, std::span<const double> shape, std::size_t) const override {
    const double total = history(m, kind_of(shape)).maxCoeff();
    return {0.005 * total, 2.0 * total};
  }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double> shape) const override {
    const Eigen::ArrayXd seen = history(m, kind_of(shape));
    return (-as_array(m.theta) * (1.0 - (-seen / shape[0]).exp())).matrix();
  }

 private:
  static History kind_of(std::span<const double> shape) { return History(std::lround(shape[1])); }

  static Eigen::ArrayXd history(const Motion& m, History kind) {
    Eigen::ArrayXd out(Eigen::Index(m.size()));
    double done = 0.0, largest = 0.0, most_stored = 0.0;
    for (std::size_t i = 0; i < m.size(); ++i) {
      const double stored = std::max(0.0, 0.5 * m.spring_nm[i] * m.theta[i]);
      if (i > 0) done += std::max(0.0, m.spring_nm[i] * (m.theta[i] - m.theta[i - 1]));
      largest = std::max(largest, std::abs(m.theta[i]));
      most_stored = std::max(most_stored, stored);
      out[Eigen::Index(i)] = kind == work_done            ? done
                             : kind == largest_deflection ? largest
                                                          : most_stored - stored;
    }
    return out;
  }
};

}  // namespace

const Effect& spring_mullins() {
  static const SpringMullins effect;
  return effect;
}

}  // namespace searig::estimator
