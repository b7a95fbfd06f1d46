// What outlasts power-down, in the EEPROM.
#pragma once

#include "payloads.h"

struct Settings {
  searig::wire::CalibrationPayload calibration;
  char name[searig::wire::IdentityPayload::kNameSize];
};

// The number of this start: one more than that of the last.
uint16_t store_count_boot();

// What was stored; where that is nothing or damaged: tare 0, gain 0 (not calibrated), "loadcell".
Settings store_read();

void store_write(const Settings& settings);
