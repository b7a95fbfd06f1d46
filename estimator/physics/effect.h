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
  virtual Term term(const Eigen::VectorXd& amplitudes, std::span<const double> shape,
                    const Model& model, const Motion& motion) const = 0;

  /// True where the amplitude cannot have this sign or size in nature (a negative friction).
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
