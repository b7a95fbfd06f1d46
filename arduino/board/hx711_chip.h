// An HX711 on two pins of a simulated AVR: converts at its own pace, shifts out on a clock line.
#pragma once

#include <simavr/sim_avr.h>
#include <simavr/sim_cycle_timers.h>

#include <cstdint>
#include <functional>

namespace searig::board {

class Hx711Chip {
 public:
  /// What it converts: counts at a cycle of the AVR, before they are held to 24 bits.
  using Input = std::function<double(avr_cycle_count_t cycle)>;

  /// Data and clock on PORTD's pins; period: cycles between conversions.
  Hx711Chip(avr_t* avr, int data_pin, int clock_pin, avr_cycle_count_t period, Input input);
  Hx711Chip(const Hx711Chip&) = delete;
  Hx711Chip& operator=(const Hx711Chip&) = delete;

  /// Goes on after the AVR was reset, which forgets all timers; the chip itself is not reset.
  void start();

  std::uint64_t conversions() const { return conversions_; }
  /// How often its clock was high for 60 us, at which a real one powers down.
  std::uint64_t powered_down() const { return powered_down_; }

 private:
  static avr_cycle_count_t on_period(avr_t*, avr_cycle_count_t when, void* self);
  static avr_cycle_count_t on_ready(avr_t*, avr_cycle_count_t when, void* self);
  static void on_clock(avr_irq_t*, std::uint32_t level, void* self);
  void convert(avr_cycle_count_t when);
  void clock(bool high);

  avr_t* avr_;
  avr_irq_t* data_;
  avr_cycle_count_t period_;
  Input input_;
  std::int32_t counts_ = 0;
  int shifted_ = 25;  ///< pulses since it was ready; 25 and more: read out
  bool clock_high_ = false;
  avr_cycle_count_t rose_at_ = 0;
  std::uint64_t conversions_ = 0;
  std::uint64_t powered_down_ = 0;
};

}  // namespace searig::board
