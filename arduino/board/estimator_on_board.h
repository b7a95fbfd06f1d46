// The one-state estimator as it runs on an Arduino Uno, in simavr: what it says and what it costs.
#pragma once

#include <simavr/sim_avr.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "arduino/estimator/mailbox.h"

namespace searig::board {

struct EstimatorStep {
  float k_nm_per_rad, variance, weight;
  std::uint64_t cycles;  ///< of this push(), with the writing of its results
};

/// Feeds the sketch of arduino/estimator one sample after the other, as fast as the AVR takes them.
/// Throws acquisition::InputError where the ELF cannot be run.
class EstimatorOnBoard {
 public:
  EstimatorOnBoard(const std::filesystem::path& elf, const estimator::FirmwareSettings& settings);
  ~EstimatorOnBoard();
  EstimatorOnBoard(const EstimatorOnBoard&) = delete;
  EstimatorOnBoard& operator=(const EstimatorOnBoard&) = delete;

  EstimatorStep push(float deflection_rad, float drive_nm);

 private:
  static void on_phase(avr_t*, avr_io_addr_t, std::uint8_t phase, void* self);
  void run_until(std::uint8_t phase);
  std::uint8_t* mailbox();

  std::filesystem::path elf_;
  avr_t* avr_;
  std::uint8_t phase_ = 0;
  std::uint64_t began_ = 0, done_ = 0;
};

}  // namespace searig::board
