// The estimator's input: one experiment, all times already on the module's clock.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace searig::estimator {

/// Telemetry of the actuator module. All vectors have the size of t_s, or are empty where the
/// recording has no such channel. Times increase strictly; the spacing need not be even.
struct ModuleSignals {
  std::vector<double> t_s;                    ///< module clock
  std::vector<double> deflection_rad;         ///< theta = q_i - q_o, always present with a spring
  std::vector<double> input_angle_rad;        ///< q_i: end of the gear train, before the spring
  std::vector<double> output_angle_rad;       ///< q_o: behind the spring, where the lever is
  std::vector<double> input_velocity_rad_s;   ///< as the module reports it
  std::vector<double> current_a;              ///< motor current I
  std::vector<double> motor_angle_rad;        ///< before the gear train
  std::vector<double> commanded_angle_rad;    ///< set point of the position loop
  std::vector<double> winding_temperature_c;  ///< motor winding
  std::vector<double> spring_temperature_c;   ///< spring element
};

/// A channel of the telemetry, named as in a recording.
struct ModuleChannel {
  std::string_view name;
  std::vector<double> ModuleSignals::*values;
};

/// All of them but the time.
inline constexpr std::array<ModuleChannel, 9> module_channels{{
    {"deflection_rad", &ModuleSignals::deflection_rad},
    {"input_angle_rad", &ModuleSignals::input_angle_rad},
    {"output_angle_rad", &ModuleSignals::output_angle_rad},
    {"input_velocity_rad_s", &ModuleSignals::input_velocity_rad_s},
    {"current_a", &ModuleSignals::current_a},
    {"motor_angle_rad", &ModuleSignals::motor_angle_rad},
    {"commanded_angle_rad", &ModuleSignals::commanded_angle_rad},
    {"winding_temperature_c", &ModuleSignals::winding_temperature_c},
    {"spring_temperature_c", &ModuleSignals::spring_temperature_c},
}};

/// The rows [from, to); a channel that does not reach so far becomes empty.
ModuleSignals rows_of(const ModuleSignals& module, std::size_t from, std::size_t to);

/// Ground truth at its own sample times.
struct LoadcellSignals {
  std::vector<double> t_s;        ///< load-cell samples, mapped to the module clock
  std::vector<double> torque_nm;  ///< force times lever arm; positive where the spring torque is
};

/// One recording as the estimator sees it.
struct Signals {
  ModuleSignals module;
  LoadcellSignals loadcell;
  double clock_ci95_s = 0.0;  ///< half width of the 95 % interval of the load-cell time mapping
  double gear_ratio = 1.0;    ///< motor turns per turn of q_i
  /// Where several recordings stand one behind the other: the module time at which each begins.
  /// Empty for one. Each has a zero of the load cell of its own.
  std::vector<double> part_starts_s;
};

}  // namespace searig::estimator
