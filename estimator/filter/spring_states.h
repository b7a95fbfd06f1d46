// What a filter of several states estimates: parameters of the spring, named as the model file
// names them, with regressors from the catalogue of effects.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "estimator/model/model.h"
#include "estimator/physics/effect.h"

namespace searig::estimator {

/// More states than this, no recording tells apart; nothing is allocated for fewer.
inline constexpr int most_states = 6;

/// One state: the amplitude of one effect. T_spring = sum_i x_i phi_i.
struct SpringState {
  std::string name;           ///< "spring.viscous"
  const Effect* effect;       ///< gives phi, and the parameter that x stands for
  std::vector<double> shape;  ///< what the effect is not linear in (a time constant): known
  bool softening = false;     ///< see SpringStates
};

/// Half the width of the 95 % interval of a Student distribution, in standard deviations.
double student_95(double dof);

/// A parameter as the model file names it, with what is known of it.
struct StateParameter {
  std::string effect, name;
  double value;
  double sd = 0;   ///< standard deviation, from the covariance handed in
  double dof = 0;  ///< degrees of freedom behind it

  double half_width_95() const { return student_95(dof) * sd; }
};

/// The states of a filter in their order. An effect that is linear in its parameter is a state as
/// it is: equation (1) is spring.linear, (12) adds spring.viscous, and so on with spring.cubic,
/// spring.temperature, spring.relaxation (a Maxwell branch), whatever the catalogue has.
///
/// spring.mullins as a state is the stiffness that the rubber has lost, N*m/rad, on top of
/// spring.linear, which is then the rested spring's: T = (k - loss) theta. It is the one state that
/// moves: it is free to change while work is done on the spring, and decays at rest. (The
/// catalogue's own law of work done has no recovery, and its scale would have to be known.)
class SpringStates {
 public:
  /// "spring.linear", "spring.viscous", ...; spring.linear must be among them. A shape stands
  /// behind colons ("spring.relaxation:0.5"), or in the model, or is the effect's usual one. Throws
  /// std::invalid_argument with one sentence.
  explicit SpringStates(const std::vector<std::string>& names, const Model* model = nullptr);

  int size() const { return static_cast<int>(states_.size()); }
  const std::vector<SpringState>& states() const { return states_; }
  int stiffness() const { return stiffness_; }                 ///< index of spring.linear
  std::optional<int> softening() const { return softening_; }  ///< index of spring.mullins

  /// The name of a channel that the motion lacks for one of the states; else empty.
  std::string lacks(const Motion& motion) const;

  /// motion.size() x size(): phi at every sample. Row i depends on nothing after the smoothing
  /// window about sample i.
  Eigen::MatrixXd regressors(const Motion& motion) const;

  /// States and their covariance -> parameters of the model file (share, per_c and the like are
  /// relative to k), to first order. With softening there is one more, "k_now_nm_per_rad" = k -
  /// loss. Shapes: x and dof are size(), covariance is size() x size().
  std::vector<StateParameter> parameters(const Eigen::VectorXd& x,
                                         const Eigen::MatrixXd& covariance,
                                         const Eigen::VectorXd& dof) const;

 private:
  std::vector<double> values(const Eigen::VectorXd& x) const;

  std::vector<SpringState> states_;
  int stiffness_ = 0;
  std::optional<int> softening_;
};

}  // namespace searig::estimator
