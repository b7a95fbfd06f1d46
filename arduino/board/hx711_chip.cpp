#include "arduino/board/hx711_chip.h"

#include <simavr/avr_ioport.h>
#include <simavr/sim_time.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace searig::board {
namespace {

constexpr int kBits = 24;
constexpr double kHighest = 0x7FFFFF;
constexpr double kLowest = -0x800000;

}  // namespace

Hx711Chip::Hx711Chip(avr_t* avr, int data_pin, int clock_pin, avr_cycle_count_t period, Input input)
    : avr_(avr),
      data_(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), data_pin)),
      period_(period),
      input_(std::move(input)) {
  avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), clock_pin), on_clock,
                          this);
  start();
}

void Hx711Chip::start() {
  avr_raise_irq(data_, shifted_ < kBits + 1 ? 0 : 1);
  avr_cycle_timer_register(avr_, period_, on_period, this);
}

avr_cycle_count_t Hx711Chip::on_period(avr_t* avr, avr_cycle_count_t when, void* self) {
  auto* const chip = static_cast<Hx711Chip*>(self);
  chip->convert(when);
  // An unread result makes way with a short high, as on the real chip.
  avr_cycle_timer_register_usec(avr, 2, on_ready, self);
  return when + chip->period_;
}

void Hx711Chip::convert(avr_cycle_count_t when) {
  ++conversions_;
  counts_ = static_cast<std::int32_t>(std::clamp(std::round(input_(when)), kLowest, kHighest));
  shifted_ = kBits + 1;
  avr_raise_irq(data_, 1);
}

avr_cycle_count_t Hx711Chip::on_ready(avr_t*, avr_cycle_count_t, void* self) {
  auto* const chip = static_cast<Hx711Chip*>(self);
  chip->shifted_ = 0;
  avr_raise_irq(chip->data_, 0);
  return 0;
}

void Hx711Chip::on_clock(avr_irq_t*, std::uint32_t level, void* self) {
  static_cast<Hx711Chip*>(self)->clock(level != 0);
}

void Hx711Chip::clock(bool high) {
  if (high == clock_high_) return;
  clock_high_ = high;
  if (!high) {
    powered_down_ += avr_cycles_to_usec(avr_, avr_->cycle - rose_at_) >= 60;
    return;
  }
  rose_at_ = avr_->cycle;
  if (shifted_ > kBits) return;
  ++shifted_;
  // Highest bit first; the pulse behind the last ends the reading and lets the line go high.
  const bool bit = shifted_ > kBits || (counts_ >> (kBits - shifted_) & 1) != 0;
  avr_raise_irq(data_, bit ? 1 : 0);
}

}  // namespace searig::board
