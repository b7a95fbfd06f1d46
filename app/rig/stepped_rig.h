// The simulated devices recorded and followed in simulated time: a minute takes seconds, and is the
// same each time.
#pragma once

#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "acquisition/recorder/device_stream.h"
#include "acquisition/recorder/output_file.h"
#include "acquisition/recorder/rolling_clock.h"
#include "app/rig/live_estimate.h"
#include "app/rig/live_signals.h"
#include "app/rig/simulated_devices.h"
#include "estimator/twin/twin.h"

namespace searig::app {

/// Both devices run as processes of their own and are heard through terminal and datagrams, as in
/// real time; but they move on only when told to, about a millisecond at a time, and an arrival is
/// stamped with the time that they have reached. The rest is what a recorder does: decode, write,
/// ping, hold the clocks against each other, follow the stiffness.
class SteppedRig {
 public:
  /// program: "searig 0.1.0". Throws std::runtime_error where there are no devices or no file.
  SteppedRig(const std::filesystem::path& file, const std::string& program,
             const DeviceOptions& options = {});

  void run_until(double seconds);

  /// Ends the recording.
  void finish();

  const History& history() const { return estimate_.history(); }
  const estimator::Model& model() const { return model_; }

  /// The truth: module time from load-cell time, and the spring as it is now.
  acquisition::ClockMap true_clock_map() const;
  double true_stiffness_nm_per_rad();

 private:
  struct Device {
    SimulatedDevice device;
    std::unique_ptr<acquisition::Source> source;
    acquisition::DeviceStream stream;
    std::uint32_t pings = 0;
  };
  Device make(acquisition::StreamId id, SimulatedDevice device) const;
  void step(long until_us);
  void hear(Device& device);
  void tell();
  void follow();
  double now_s() const { return 1e-6 * static_cast<double>(now_us_); }

  DeviceOptions options_;
  Device module_, loadcell_;  // before the file, so that none is made where they cannot be
  acquisition::OutputFile file_;
  acquisition::mcap::RecordingWriter out_;
  acquisition::mcap::Settings settings_;
  std::vector<acquisition::Entry> entries_;
  std::vector<acquisition::Arrival> arrivals_;
  acquisition::RollingClock clock_;
  estimator::twin::Twin twin_;
  estimator::Model model_;
  LiveSignals signals_;
  LiveEstimate estimate_;
  std::mt19937_64 random_{1};  ///< of the steps
  long now_us_ = 0;
};

}  // namespace searig::app
