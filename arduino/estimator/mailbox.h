// What the sketch and the program that runs it in simavr share: a place in the AVR's memory.
#pragma once

#include <stdint.h>

#include "estimator/filter/firmware_stiffness.h"

namespace searig {
namespace board {

/// Little-endian, without gaps on the AVR and on the host. The sketch writes its address to GPIOR1
/// (low) and GPIOR2 (high), and to GPIOR0 what it is about to do.
struct Mailbox {
  estimator::FirmwareSettings settings;  ///< to be there before kReady is answered
  float deflection, drive;               ///< to be there before each kWaits is answered
  float k, variance, weight;             ///< after each kDone
};

enum Phase : uint8_t { kReady = 1, kBegins = 2, kDone = 3 };

}  // namespace board
}  // namespace searig
