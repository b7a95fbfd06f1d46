// Effects that are a sum of alike elements: Maxwell branches, friction elements in parallel.
#pragma once

#include "estimator/physics/effect.h"

namespace searig::estimator {

/// Each branch has one amplitude and one shape parameter. The first branch's parameters are
/// required; further branches (up to max_branches) are named with their number.
class Branches : public Effect {
 public:
  static constexpr int max_branches = 4;

  Eigen::VectorXd amplitudes(const Term& term, const Model& model) const override;
  std::vector<double> shape(const Term& term) const override;
  std::string complaint(const Term& term) const override;
  Term term(const Eigen::VectorXd& amplitudes, std::span<const double> shape, const Model& model,
            const Motion& motion) const override;
  Eigen::MatrixXd features(const Motion& motion, std::span<const double> shape) const override;
  bool has_branches() const override { return true; }
  std::size_t free_shape(std::span<const double> shape) const override { return shape.size(); }
  bool physical(const Eigen::VectorXd& amplitudes) const override {
    return amplitudes.minCoeff() > 0;
  }

 protected:
  /// How one branch's parameter is called: prefix, number (the first may be unnumbered), unit.
  struct Name {
    std::string prefix, unit, meaning;
    bool first_numbered;
  };
  Branches(Description about, const Name& amplitude, const Name& shape);

  virtual Eigen::VectorXd column(const Motion& motion, double shape) const = 0;
};

}  // namespace searig::estimator
