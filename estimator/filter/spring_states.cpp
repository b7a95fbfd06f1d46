#include "estimator/filter/spring_states.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "estimator/physics/catalogue.h"

namespace searig::estimator {

namespace {

constexpr const char* linear = "spring.linear";
constexpr const char* mullins = "spring.mullins";

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw std::invalid_argument("the state " + name + " " + why);
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ':');) out.push_back(part);
  return out;
}

double number(const std::string& name, const std::string& text) {
  std::size_t used = 0;
  double value = 0;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
  }
  if (used == 0 || used != text.size() || !std::isfinite(value)) {
    refuse(name, "has " + text + " behind its colon, which is no number");
  }
  return value;
}

// As given, else as the model has it, else the only one that the effect knows.
std::vector<double> shape_of(const Effect& effect, const std::vector<double>& given,
                             const Model* model) {
  if (!given.empty()) return given;
  if (const Term* term = model ? model->find(effect.name()) : nullptr) return effect.shape(*term);
  const auto usual = effect.shape_grid(Motion{});
  if (usual.size() == 1) return usual.front();
  const std::string shape = effect.parameters().at(1).name;
  refuse(effect.name(), "needs its " + shape + ", behind a colon or in the model");
}

SpringState state_of(const std::string& text, const Model* model) {
  const auto parts = split(text);
  const std::string name = parts.empty() ? text : parts.front();
  const Effect* effect = find_effect(name);
  if (!effect || effect->path() != Path::spring) {
    refuse(name, "is not one of the catalogue's spring effects");
  }
  if (!effect->tied_to().empty()) refuse(name, "has no parameter that the torque is linear in");
  if (name == mullins) return {name, effect, {1, 0}, true};

  std::vector<double> given;
  for (std::size_t i = 1; i < parts.size(); ++i) given.push_back(number(name, parts[i]));
  SpringState state{name, effect, shape_of(*effect, given, model)};
  const std::size_t shapes = effect->has_branches() ? 1 : effect->parameters().size() - 1;
  if (state.shape.size() != shapes) {
    refuse(name, "takes " + std::to_string(shapes) + " numbers of shape, not " +
                     std::to_string(state.shape.size()));
  }
  const auto outside = [&](std::size_t i) {
    const Parameter& p = effect->parameters()[i + 1];
    const bool is_time_or_size = effect->has_branches();
    return state.shape[i] < p.lower || state.shape[i] > p.upper ||
           (is_time_or_size && state.shape[i] == 0);
  };
  for (std::size_t i = 0; i < shapes; ++i) {
    if (outside(i)) refuse(name, "has a " + effect->parameters()[i + 1].name + " out of range");
  }
  return state;
}

}  // namespace

// Cornish and Fisher's series about the normal quantile z (M. Abramowitz, I. Stegun, 26.7.5);
// within 0.5 % from 3 degrees of freedom on.
double student_95(double dof) {
  const double z = 1.959963984540054, z2 = z * z;
  const double g1 = z * (z2 + 1) / 4;
  const double g2 = z * ((5 * z2 + 16) * z2 + 3) / 96;
  const double g3 = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384;
  const double g4 = z * ((((79 * z2 + 776) * z2 + 1482) * z2 - 1920) * z2 - 945) / 92160;
  return z + (g1 + (g2 + (g3 + g4 / dof) / dof) / dof) / dof;
}

SpringStates::SpringStates(const std::vector<std::string>& names, const Model* model) {
  if (names.size() > most_states) {
    throw std::invalid_argument("at most " + std::to_string(most_states) +
                                " states can be estimated together");
  }
  bool has_stiffness = false;
  for (const std::string& name : names) {
    SpringState state = state_of(name, model);
    const bool again = std::ranges::any_of(
        states_, [&](const SpringState& other) { return other.name == state.name; });
    if (again) refuse(state.name, "is named twice");
    if (state.name == linear) has_stiffness = true, stiffness_ = size();
    if (state.softening) softening_ = size();
    states_.push_back(std::move(state));
  }
  if (!has_stiffness) throw std::invalid_argument("spring.linear must be among the states");
}

std::string SpringStates::lacks(const Motion& motion) const {
  for (const SpringState& state : states_) {
    if (state.softening || state.effect->applies(motion)) continue;
    return motion.has_spring() ? state.effect->about().channel : "deflection_rad";
  }
  return {};
}

Eigen::MatrixXd SpringStates::regressors(const Motion& motion) const {
  Eigen::MatrixXd phi(static_cast<Eigen::Index>(motion.size()), size());
  for (int i = 0; i < size(); ++i) {
    const SpringState& state = states_[static_cast<std::size_t>(i)];
    if (!state.softening) phi.col(i) = state.effect->features(motion, state.shape).col(0);
  }
  if (softening_) phi.col(*softening_) = -phi.col(stiffness_);  // T = (k - loss) theta
  return phi;
}

std::vector<double> SpringStates::values(const Eigen::VectorXd& x) const {
  Model with_k;  // what share and per_c are relative to
  with_k.set(linear, states_[static_cast<std::size_t>(stiffness_)].effect->parameters()[0].name,
             x[stiffness_]);
  std::vector<double> out;
  for (int i = 0; i < size(); ++i) {
    const SpringState& state = states_[static_cast<std::size_t>(i)];
    const Eigen::VectorXd amplitude = Eigen::VectorXd::Constant(1, x[i]);
    const Term term = state.effect->term(amplitude, state.shape, with_k, Motion{});
    out.push_back(term.parameters.at(state.effect->parameters()[0].name));
  }
  if (softening_) out.push_back(x[stiffness_] - x[*softening_]);
  return out;
}

std::vector<StateParameter> SpringStates::parameters(const Eigen::VectorXd& x,
                                                     const Eigen::MatrixXd& covariance,
                                                     const Eigen::VectorXd& dof) const {
  const auto at_x = values(x);
  Eigen::MatrixXd slope(at_x.size(), size());
  for (int j = 0; j < size(); ++j) {
    const double step = 1e-6 * (std::abs(x[j]) + std::sqrt(covariance(j, j))) + 1e-300;
    Eigen::VectorXd beside = x;
    beside[j] += step;
    const auto at_beside = values(beside);
    for (std::size_t i = 0; i < at_x.size(); ++i) {
      slope(static_cast<Eigen::Index>(i), j) = (at_beside[i] - at_x[i]) / step;
    }
  }
  const Eigen::VectorXd variance = (slope * covariance * slope.transpose()).diagonal();
  std::vector<StateParameter> out;
  for (std::size_t i = 0; i < at_x.size(); ++i) {
    const bool own = i < states_.size();
    const SpringState& state = states_[own ? i : static_cast<std::size_t>(stiffness_)];
    const auto index = static_cast<Eigen::Index>(own ? i : static_cast<std::size_t>(stiffness_));
    out.push_back({state.name, own ? state.effect->parameters()[0].name : "k_now_nm_per_rad",
                   at_x[i], std::sqrt(std::max(0.0, variance[static_cast<Eigen::Index>(i)])),
                   dof[index]});
  }
  return out;
}

}  // namespace searig::estimator
