// An Arduino Uno that runs the real firmware in simavr, in a time that the caller owns.
#pragma once

#include <simavr/sim_avr.h>

#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "arduino/board/hx711_chip.h"

namespace searig::board {

struct BoardSettings {
  std::filesystem::path firmware;  ///< the ELF
  double skew_ppm = 0.0;           ///< how much too fast the board's quartz is
  double hx711_hz = 93.4;  ///< of the converter's own oscillator; 11.7 with its RATE pin low
  double counts_per_newton = 2000.0;
  double counts_at_rest = 84000.0;
  double mv_per_newton = 20.0;  ///< of the analogue amplifier, which rests at 2.5 V
  std::uint16_t last_boot = 0;  ///< the EEPROM's count of starts
};

/// Force at the load cell, N, at a true time, s since the board's start. Asked in rising order.
using Force = std::function<double(double true_s)>;

class SimulatedBoard {
 public:
  static constexpr std::size_t kEepromSize = 1023;  ///< simavr 1.6 refuses to copy the last byte
  using Eeprom = std::array<std::uint8_t, kEepromSize>;

  /// Throws acquisition::InputError where the firmware cannot be run.
  SimulatedBoard(const BoardSettings& settings, Force force);
  ~SimulatedBoard();
  SimulatedBoard(const SimulatedBoard&) = delete;
  SimulatedBoard& operator=(const SimulatedBoard&) = delete;

  /// Runs up to a true time, s since the start.
  void run_until(double true_s);

  /// Bytes to the board's serial line; they go in one after the other from now on.
  void receive(std::span<const std::uint8_t> bytes);

  struct SentByte {
    std::uint8_t byte;
    double true_s;  ///< when its last bit was out
  };
  /// What the board has sent since the last call.
  std::vector<SentByte> take_sent();

  /// A force that stands still in place of the motion's, N, as a known weight is; none: the motion.
  void hold(std::optional<double> force_n) { held_n_ = force_n; }

  /// The reset button.
  void reset();

  Eeprom eeprom() const;
  void set_eeprom(const Eeprom& eeprom);

  double true_s() const { return seconds(avr_->cycle); }
  double device_hz() const { return cycles_per_s_; }
  const Hx711Chip& hx711() const { return *hx711_; }

 private:
  struct Destroy {
    void operator()(avr_t* avr) const;
  };
  static void on_sent(avr_irq_t*, std::uint32_t byte, void* self);
  static avr_cycle_count_t on_incoming(avr_t*, avr_cycle_count_t when, void* self);
  static void on_conversion(avr_irq_t*, std::uint32_t mux, void* self);
  double seconds(avr_cycle_count_t cycle) const {
    return static_cast<double>(cycle) / cycles_per_s_;
  }
  void connect();
  double force_n(double true_s) const { return held_n_ ? *held_n_ : force_(true_s); }

  BoardSettings settings_;
  Force force_;
  std::optional<double> held_n_;
  double cycles_per_s_;  ///< true seconds
  std::unique_ptr<avr_t, Destroy> avr_;
  std::unique_ptr<Hx711Chip> hx711_;
  std::deque<std::uint8_t> incoming_;
  std::vector<SentByte> sent_;
};

}  // namespace searig::board
