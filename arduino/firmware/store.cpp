#include "store.h"

#include <avr/eeprom.h>

namespace {

using namespace searig::wire;

// The boot count has a place of its own: a power cut while it is written cannot hurt the settings.
uint16_t* const kBootAt = reinterpret_cast<uint16_t*>(0);
uint8_t* const kSettingsAt = reinterpret_cast<uint8_t*>(16);
const uint8_t kSize = CalibrationPayload::kSize + IdentityPayload::kNameSize;

}  // namespace

uint16_t store_count_boot() {
  const uint16_t boot = eeprom_read_word(kBootAt) + 1;  // a new EEPROM holds 0xFFFF
  eeprom_update_word(kBootAt, boot);
  return boot;
}

Settings store_read() {
  uint8_t bytes[kSize + kCrcSize];
  eeprom_read_block(bytes, kSettingsAt, sizeof bytes);
  Settings settings;
  memset(&settings, 0, sizeof settings);
  strcpy(settings.name, "loadcell");
  if (Reader(bytes + kSize).u16() != crc16(bytes, kSize)) return settings;
  settings.calibration = CalibrationPayload::read(bytes);
  memcpy(settings.name, bytes + CalibrationPayload::kSize, IdentityPayload::kNameSize);
  return settings;
}

void store_write(const Settings& settings) {
  uint8_t bytes[kSize + kCrcSize];
  settings.calibration.write(bytes);
  memcpy(bytes + CalibrationPayload::kSize, settings.name, IdentityPayload::kNameSize);
  Writer(bytes + kSize).u16(crc16(bytes, kSize));
  eeprom_update_block(bytes, kSettingsAt, sizeof bytes);
}
