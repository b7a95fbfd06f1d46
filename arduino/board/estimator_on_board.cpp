#include "arduino/board/estimator_on_board.h"

#include <simavr/sim_elf.h>
#include <simavr/sim_io.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "acquisition/error.h"

namespace searig::board {
namespace {

// Data-space addresses of the ATmega328P's three registers for whoever needs one.
constexpr std::size_t kGpior0 = 0x3E, kGpior1 = 0x4A, kGpior2 = 0x4B;

void silent(avr_t*, const int, const char*, va_list) {}

}  // namespace

EstimatorOnBoard::EstimatorOnBoard(const std::filesystem::path& elf,
                                   const estimator::FirmwareSettings& settings)
    : elf_(elf) {
  avr_global_logger_set(silent);
  elf_firmware_t firmware{};
  if (elf_read_firmware(elf.c_str(), &firmware) != 0) {
    throw acquisition::InputError(elf.string() + " is no firmware: it cannot be read as an ELF");
  }
  avr_ = avr_make_mcu_by_name("atmega328p");
  avr_init(avr_);
  firmware.frequency = 16'000'000;
  avr_load_firmware(avr_, &firmware);
  avr_register_io_write(avr_, kGpior0, on_phase, this);
  run_until(kReady);
  std::memcpy(mailbox() + offsetof(Mailbox, settings), &settings, sizeof settings);
}

EstimatorOnBoard::~EstimatorOnBoard() {
  avr_terminate(avr_);
  std::free(avr_);
}

EstimatorStep EstimatorOnBoard::push(float deflection_rad, float drive_nm) {
  std::memcpy(mailbox() + offsetof(Mailbox, deflection), &deflection_rad, sizeof(float));
  std::memcpy(mailbox() + offsetof(Mailbox, drive), &drive_nm, sizeof(float));
  run_until(kDone);
  EstimatorStep out{};
  std::memcpy(&out, mailbox() + offsetof(Mailbox, k), 3 * sizeof(float));
  out.cycles = done_ - began_;
  return out;
}

void EstimatorOnBoard::on_phase(avr_t* avr, avr_io_addr_t, std::uint8_t phase, void* self) {
  auto* const board = static_cast<EstimatorOnBoard*>(self);
  board->phase_ = phase;
  if (phase == kBegins) board->began_ = avr->cycle;
  if (phase == kDone) board->done_ = avr->cycle;
}

void EstimatorOnBoard::run_until(std::uint8_t phase) {
  phase_ = 0;
  while (phase_ != phase) {
    const int state = avr_run(avr_);
    if (state == cpu_Crashed || state == cpu_Done) {
      throw acquisition::InputError(elf_.string() + " has crashed the simulated AVR");
    }
  }
}

std::uint8_t* EstimatorOnBoard::mailbox() {
  return avr_->data + avr_->data[kGpior1] + 256 * avr_->data[kGpior2];
}

}  // namespace searig::board
