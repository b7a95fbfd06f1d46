// The estimator on an Arduino, fed from outside: measures what it costs. A program that runs this
// in simavr puts each sample into the mailbox when GPIOR0 says kReady or kDone, and counts the
// cycles between kBegins and kDone.
#include "arduino/estimator/mailbox.h"

using searig::board::Mailbox;

static volatile Mailbox mailbox;

// Copies through volatile, as the outside changes it behind the compiler's back.
static searig::estimator::FirmwareSettings settings() {
  searig::estimator::FirmwareSettings out;
  const volatile uint8_t* from = reinterpret_cast<const volatile uint8_t*>(&mailbox.settings);
  uint8_t* to = reinterpret_cast<uint8_t*>(&out);
  for (uint8_t i = 0; i < sizeof out; ++i) to[i] = from[i];
  return out;
}

void setup() {
  cli();  // no timer ticks in the count
  GPIOR1 = reinterpret_cast<uint16_t>(&mailbox) & 0xFF;
  GPIOR2 = reinterpret_cast<uint16_t>(&mailbox) >> 8;
  GPIOR0 = searig::board::kReady;
  static searig::estimator::FirmwareStiffness<> estimator(settings());
  for (;;) {
    const float deflection = mailbox.deflection, drive = mailbox.drive;
    GPIOR0 = searig::board::kBegins;
    estimator.push(deflection, drive);
    mailbox.k = estimator.k_nm_per_rad();
    mailbox.variance = estimator.variance();
    mailbox.weight = estimator.weight();
    GPIOR0 = searig::board::kDone;
  }
}

void loop() {}
