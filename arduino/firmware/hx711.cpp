// An HX711. It converts at its own pace (measured: 93.4 or 11.7 Hz) and pulls its data line low
// when a reading is ready; that moment, caught by an interrupt, is the reading's time. A tick sends
// the newest reading, with the time at which that was ready.
#include "settings.h"
#if !SEARIG_ANALOGUE
#include <Arduino.h>

#include "payloads.h"
#include "sensor.h"

namespace {

using searig::wire::LoadcellPayload;

const int32_t kHighest = 0x7FFFFF;
const int32_t kLowest = -0x800000;
const uint8_t kSettling = 4;  // readings, after power-up (data sheet: settling time)

volatile uint8_t* data_port;
volatile uint8_t* clock_port;
uint8_t data_mask;
uint8_t clock_mask;

volatile bool ready = false;
volatile uint32_t ready_us = 0;
volatile uint8_t ticks = 0;
uint16_t overruns = 0;

Reading latest;
bool fresh = false;    // not sent yet
uint8_t readings = 0;  // up to kSettling + 1

bool data_is_low() {
  return (*data_port & data_mask) == 0;
}

void watch_data_line(bool on) {
  volatile uint8_t* const mask = digitalPinToPCMSK(kHx711DataPin);
  const uint8_t bit = _BV(digitalPinToPCMSKbit(kHx711DataPin));
  PCIFR = _BV(digitalPinToPCICRbit(kHx711DataPin));  // forget what reading did to the line
  *mask = on ? (*mask | bit) : (*mask & ~bit);
}

// One clock pulse; the bit that the converter puts on its data line. An interrupt while the clock
// is high could last 60 us, at which the HX711 powers down.
uint8_t pulse() {
  noInterrupts();
  *clock_port |= clock_mask;
  delayMicroseconds(1);
  const uint8_t bit = data_is_low() ? 0 : 1;
  *clock_port &= ~clock_mask;
  interrupts();
  delayMicroseconds(1);
  return bit;
}

int32_t shift_in() {
  uint32_t bits = 0;
  for (uint8_t i = 0; i < 24; ++i) bits = (bits << 1) | pulse();
  pulse();  // the 25th asks for channel A at gain 128 next time
  if (bits & 0x800000UL) bits |= 0xFF000000UL;
  return static_cast<int32_t>(bits);
}

}  // namespace

// Pins D0 to D7.
ISR(PCINT2_vect) {
  if (!data_is_low()) return;
  ready_us = micros();
  ready = true;
}

void sensor_begin() {
  pinMode(kHx711DataPin, INPUT);
  pinMode(kHx711ClockPin, OUTPUT);
  data_port = portInputRegister(digitalPinToPort(kHx711DataPin));
  clock_port = portOutputRegister(digitalPinToPort(kHx711ClockPin));
  data_mask = digitalPinToBitMask(kHx711DataPin);
  clock_mask = digitalPinToBitMask(kHx711ClockPin);
  *clock_port &= ~clock_mask;
  PCICR |= _BV(digitalPinToPCICRbit(kHx711DataPin));
  watch_data_line(true);
  if (data_is_low()) {  // was ready before we watched: settling, so its time matters little
    ready_us = micros();
    ready = true;
  }
}

void sensor_on_tick() {
  ++ticks;
}

void sensor_poll() {
  if (!ready) return;
  watch_data_line(false);
  latest.time_us = ready_us;
  latest.counts = shift_in();
  ready = false;
  watch_data_line(true);
  if (readings <= kSettling) ++readings;
  latest.flags = 0;
  if (latest.counts >= kHighest || latest.counts <= kLowest) {
    latest.flags |= LoadcellPayload::at_limit;
  }
  if (readings <= kSettling) latest.flags |= LoadcellPayload::settling;
  fresh = true;
}

bool sensor_has_news() {
  return ready || ticks > 0;
}

bool sensor_due(Reading* reading) {
  if (ticks == 0) return false;
  noInterrupts();
  const uint8_t elapsed = ticks;
  ticks = 0;
  interrupts();
  if (readings == 0) return false;  // nothing to send yet
  overruns += elapsed - 1;
  *reading = latest;
  if (!fresh) reading->flags |= LoadcellPayload::repeated;
  fresh = false;
  return true;
}

uint16_t sensor_overruns() {
  return overruns;
}
#endif
