#include "estimator/physics/branches.h"

#include <array>

namespace searig::estimator {
namespace {

std::vector<Parameter> branch_parameters(const auto& amplitude, const auto& shape) {
  std::vector<Parameter> out;
  for (int branch = 1; branch <= Branches::max_branches; ++branch)
    for (const auto* name : std::array{&amplitude, &shape}) {
      const bool numbered = branch > 1 || name->first_numbered;
      out.push_back({name->prefix + (numbered ? std::to_string(branch) : "") + name->unit,
                     0,
                     unlimited,
                     name->meaning,
                     {}});
      if (branch > 1) out.back().fallback = 0.0;
    }
  return out;
}

}  // namespace

Branches::Branches(Description about, const Name& amplitude, const Name& shape)
    : Effect(std::move(about), branch_parameters(amplitude, shape)) {}

Eigen::VectorXd Branches::amplitudes(const Term& term, const Model&) const {
  const auto branches = Eigen::Index(shape(term).size());
  Eigen::VectorXd out(branches);
  for (Eigen::Index i = 0; i < branches; ++i)
    out[i] = term.parameters.at(parameters()[std::size_t(2 * i)].name);
  return out;
}

std::vector<double> Branches::shape(const Term& term) const {
  std::vector<double> out;
  for (std::size_t i = 1; i < parameters().size(); i += 2) {
    const auto it = term.parameters.find(parameters()[i].name);
    if (it == term.parameters.end()) break;
    out.push_back(it->second);
  }
  return out;
}

std::string Branches::complaint(const Term& term) const {
  bool ended = false;
  for (std::size_t i = 0; i < parameters().size(); i += 2) {
    const auto &amplitude = parameters()[i].name, &shape = parameters()[i + 1].name;
    const bool has_amplitude = term.parameters.contains(amplitude);
    const bool has_shape = term.parameters.contains(shape);
    if (has_amplitude != has_shape)
      return has_shape ? "has " + shape + " but no " + amplitude
                       : "has " + amplitude + " but no " + shape;
    if (has_amplitude && ended) return "has " + amplitude + " but not the branch before it";
    ended = ended || !has_amplitude;
  }
  return {};
}

Term Branches::term(const Eigen::VectorXd& amplitudes, std::span<const double> shape, const Model&,
                    const Motion&) const {
  Term out{name(), {}};
  for (std::size_t i = 0; i < shape.size() && i < max_branches; ++i) {
    out.parameters[parameters()[2 * i].name] = amplitudes[Eigen::Index(i)];
    out.parameters[parameters()[2 * i + 1].name] = shape[i];
  }
  return out;
}

Eigen::MatrixXd Branches::features(const Motion& motion, std::span<const double> shape) const {
  Eigen::MatrixXd out(Eigen::Index(motion.size()), Eigen::Index(shape.size()));
  for (std::size_t i = 0; i < shape.size(); ++i)
    out.col(Eigen::Index(i)) = column(motion, shape[i]);
  return out;
}

}  // namespace searig::estimator
