// What every physical effect provides. One file in effects/ per effect; the catalogue lists them
// all.
//
// An effect is a torque that is linear in its amplitudes and free in its shape:
//
//   contribution(t) = sum_i amplitude_i * feature_i(t; shape)
//
// so that one definition serves the simulation (amplitudes from the model file), the diagnosis
// (amplitudes by least squares, shape by a grid and then Ceres), the documentation and the report.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "estimator/model/model.h"
#include "estimator/physics/motion.h"

namespace searig::estimator {

/// Where an effect enters: + in T_spring, + in T_drive (friction carries its own minus), or + in
/// what the load cell reads; `observation` changes when and how sharply the load cell sees it.
enum class Path { spring, drive, rig, observation };

/// A bound that is none.
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// One parameter as the model file names it.
struct Parameter {
  std::string name;  ///< with its unit
  double lower, upper;
  std::string meaning;
  std::optional<double> fallback = {};  ///< what holds where the file does not say; else required
};

/// Everything a person is told about an effect.
struct Description {
  std::string name;  ///< "spring.viscous"
  Path path;
  std::string title;  ///< for a technician: "the spring resists speed"
  std::string equation;
  std::string looks_like;
  std::string confused_with;
  std::string separated_by;  ///< the experiment that tells it from those
  std::string channel;       ///< over which it is local, named as in the diagnosis
  std::string source;
};

class Effect {
 public:
  virtual ~Effect() = default;

  const Description& about() const { return about_; }
  const std::string& name() const { return about_.name; }
  Path path() const { return about_.path; }
  const std::vector<Parameter>& parameters() const { return parameters_; }
  bool has_parameter(std::string_view parameter) const;

  /// Whether the motion has the channels that the effect acts on.
  virtual bool applies(const Motion& motion) const = 0;

  /// motion.size() x amplitudes; `shape` as shape_grid() gives it.
  virtual Eigen::MatrixXd features(const Motion& motion, std::span<const double> shape) const = 0;

  /// Shapes worth trying on this motion; each as long as the effect has shape parameters. An
  /// effect without shape has one empty shape.
  virtual std::vector<std::vector<double>> shape_grid(const Motion&) const { return {{}}; }

  /// The model file's parameters <-> amplitudes and shape. `model` gives the numbers that some
  /// effects are relative to (k, efficiency*torque_constant).
  virtual Eigen::VectorXd amplitudes(const Term& term, const Model& model) const = 0;
  virtual std::vector<double> shape(const Term&) const { return {}; }
  /// What is wrong with the term's parameters taken together, as the end of a sentence; else empty.
  virtual std::string complaint(const Term&) const { return {}; }
  virtual Term term(const Eigen::VectorXd& amplitudes, std::span<const double> shape,
                    const Model& model, const Motion& motion) const = 0;

  /// How many of the shape's leading values are continuous and may be polished; the others are
  /// choices or constants.
  virtual std::size_t free_shape(std::span<const double>) const { return 0; }

  /// Whether further elements of the same kind may be added (Maxwell branches).
  virtual bool has_branches() const { return false; }

  /// Range that a free shape value may be polished in. Beyond it the effect becomes another one in
  /// disguise (a relaxation too fast to see is a damper), so it must win inside.
  struct Range {
    double lower, upper;
  };
  virtual Range shape_range(const Motion&, std::span<const double> /*shape*/,
                            std::size_t /*value*/) const {
    return {1e-9, 1e9};
  }

  /// The amplitude that a small mismatch of the channels' filters can feign: an averaging window
  /// of width_s more on one channel than on another. Smaller amplitudes are not asserted.
  virtual double feigned(const Model&, double) const { return 0.0; }

  /// False where nature does not have this sign (a negative friction).
  virtual bool physical(const Eigen::VectorXd&) const { return true; }

  /// The amplitude is that of this other effect, not one of its own (a dead zone acts on k*theta).
  virtual std::string_view tied_to() const { return {}; }

 protected:
  Effect(Description about, std::vector<Parameter> parameters)
      : about_(std::move(about)), parameters_(std::move(parameters)) {}

 private:
  Description about_;
  std::vector<Parameter> parameters_;
};

}  // namespace searig::estimator
