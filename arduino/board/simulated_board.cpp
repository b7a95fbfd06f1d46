#include "arduino/board/simulated_board.h"

#include <simavr/avr_adc.h>
#include <simavr/avr_eeprom.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_elf.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "acquisition/error.h"

namespace searig::board {
namespace {

constexpr double kQuartz = 16e6;                  // Hz
constexpr avr_cycle_count_t kByte = 10 * 8 * 17;  // cycles at 115200 baud as the AVR makes them
constexpr avr_cycle_count_t kHeld = 12 * 16;      // cycles from an ADC's start to its holding
constexpr int kDataPin = 4;
constexpr int kClockPin = 5;
constexpr std::uint32_t kSupply = 5000;  // mV

void silent(avr_t*, const int, const char*, va_list) {}

/// simavr's own would wait in real time; here a sleeping core's time just passes.
void pass(avr_t*, avr_cycle_count_t) {}

/// A sleeping core goes on to its next timer: this one keeps it from going too far.
avr_cycle_count_t stop_here(avr_t*, avr_cycle_count_t, void*) {
  return 0;
}

avr_t* make_board(const std::filesystem::path& file) {
  elf_firmware_t firmware{};
  if (elf_read_firmware(file.c_str(), &firmware) != 0) {
    throw acquisition::InputError(file.string() + " is no firmware: it cannot be read as an ELF");
  }
  avr_t* const avr = avr_make_mcu_by_name("atmega328p");
  avr_init(avr);
  firmware.frequency = static_cast<std::uint32_t>(kQuartz);
  avr_load_firmware(avr, &firmware);
  avr->sleep = pass;
  avr->vcc = avr->avcc = avr->aref = kSupply;
  return avr;
}

}  // namespace

void SimulatedBoard::Destroy::operator()(avr_t* avr) const {
  avr_terminate(avr);
  std::free(avr);
}

SimulatedBoard::SimulatedBoard(const BoardSettings& settings, Force force)
    : settings_(settings),
      force_(std::move(force)),
      cycles_per_s_(kQuartz * (1.0 + settings.skew_ppm * 1e-6)) {
  avr_global_logger_set(silent);
  avr_.reset(make_board(settings.firmware));
  Eeprom blank;
  blank.fill(0xFF);
  blank[0] = static_cast<std::uint8_t>(settings.last_boot);
  blank[1] = static_cast<std::uint8_t>(settings.last_boot >> 8);
  set_eeprom(blank);
  connect();
}

SimulatedBoard::~SimulatedBoard() = default;

void SimulatedBoard::connect() {
  avr_t* const avr = avr_.get();
  std::uint32_t no_flags = 0;  // neither sleep while the firmware polls nor print what it sends
  avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &no_flags);
  avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), on_sent,
                          this);
  avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER),
                          on_conversion, this);
  const auto period = static_cast<avr_cycle_count_t>(cycles_per_s_ / settings_.hx711_hz);
  hx711_ = std::make_unique<Hx711Chip>(
      avr, kDataPin, kClockPin, period, [this](avr_cycle_count_t cycle) {
        return settings_.counts_at_rest + settings_.counts_per_newton * force_n(seconds(cycle));
      });
}

void SimulatedBoard::on_sent(avr_irq_t*, std::uint32_t byte, void* self) {
  auto* const board = static_cast<SimulatedBoard*>(self);
  board->sent_.push_back(
      {static_cast<std::uint8_t>(byte), board->seconds(board->avr_->cycle + kByte)});
}

void SimulatedBoard::on_conversion(avr_irq_t*, std::uint32_t, void* self) {
  auto* const board = static_cast<SimulatedBoard*>(self);
  const double force = board->force_n(board->seconds(board->avr_->cycle + kHeld));
  const double mv = std::clamp(0.5 * kSupply + board->settings_.mv_per_newton * force, 0.0,
                               static_cast<double>(kSupply));
  avr_raise_irq(avr_io_getirq(board->avr_.get(), AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0),
                static_cast<std::uint32_t>(std::lround(mv)));
}

void SimulatedBoard::run_until(double true_s) {
  const auto until = static_cast<avr_cycle_count_t>(std::max(0.0, true_s * cycles_per_s_));
  if (until <= avr_->cycle) return;
  avr_cycle_timer_register(avr_.get(), until - avr_->cycle, stop_here, this);
  while (avr_->cycle < until) {
    const int state = avr_run(avr_.get());
    if (state == cpu_Crashed || state == cpu_Done) {
      throw acquisition::InputError(settings_.firmware.string() + " has crashed the simulated AVR");
    }
  }
}

void SimulatedBoard::receive(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return;
  if (incoming_.empty()) avr_cycle_timer_register(avr_.get(), kByte, on_incoming, this);
  incoming_.insert(incoming_.end(), bytes.begin(), bytes.end());
}

/// Every byte takes its time on the line.
avr_cycle_count_t SimulatedBoard::on_incoming(avr_t* avr, avr_cycle_count_t when, void* self) {
  auto& incoming = static_cast<SimulatedBoard*>(self)->incoming_;
  avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT), incoming.front());
  incoming.pop_front();
  return incoming.empty() ? 0 : when + kByte;
}

std::vector<SimulatedBoard::SentByte> SimulatedBoard::take_sent() {
  return std::exchange(sent_, {});
}

void SimulatedBoard::reset() {
  avr_reset(avr_.get());  // forgets all timers
  incoming_.clear();
  hx711_->start();
}

SimulatedBoard::Eeprom SimulatedBoard::eeprom() const {
  Eeprom bytes{};
  avr_eeprom_desc_t all{nullptr, 0, kEepromSize};
  all.ee = bytes.data();
  avr_ioctl(avr_.get(), AVR_IOCTL_EEPROM_GET, &all);
  return bytes;
}

void SimulatedBoard::set_eeprom(const Eeprom& eeprom) {
  Eeprom bytes = eeprom;
  avr_eeprom_desc_t all{bytes.data(), 0, kEepromSize};
  avr_ioctl(avr_.get(), AVR_IOCTL_EEPROM_SET, &all);
}

}  // namespace searig::board
