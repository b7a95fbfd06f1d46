// An amplifier on an analogue pin. Each tick starts a burst of conversions that are summed, which
// averages their noise and gives four bits more; the burst's middle is the reading's time.
#include "settings.h"
#if SEARIG_ANALOGUE
#include <Arduino.h>

#include "payloads.h"
#include "sensor.h"

namespace {

using searig::wire::LoadcellPayload;

const uint16_t kHighest = 1023;
// The converter holds its input 1.5 of its 8 us clocks after a start and is done 13 clocks after
// it, so the held moments lie that much before the middle of start and end.
const uint32_t kHeldBeforeMiddle_us = (13 * 8 - 2 * 12) / 2;

volatile uint8_t left = 0;  // conversions of the burst still to come
volatile bool done = false;
volatile uint16_t sum = 0;
volatile bool limit = false;
volatile uint32_t start_us = 0;
volatile uint32_t end_us = 0;
volatile uint16_t overruns = 0;

}  // namespace

ISR(ADC_vect) {
  const uint16_t value = ADC;
  sum += value;
  if (value == 0 || value == kHighest) limit = true;
  if (--left > 0) {
    ADCSRA |= _BV(ADSC);
    return;
  }
  end_us = micros();
  done = true;
}

void sensor_begin() {
  ADMUX = _BV(REFS0) | kAnalogueChannel;  // against the supply, as a bridge amplifier measures
  ADCSRA = _BV(ADEN) | _BV(ADIE) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);  // 125 kHz
}

void sensor_on_tick() {
  if (left > 0 || done) {  // the last reading is not fetched
    ++overruns;
    return;
  }
  sum = 0;
  limit = false;
  left = kAnalogueBurst;
  ADCSRA |= _BV(ADSC);
  start_us = micros();
}

void sensor_poll() {}

bool sensor_has_news() {
  return done;
}

bool sensor_due(Reading* reading) {
  if (!done) return false;
  reading->counts = sum;
  reading->time_us = start_us + (end_us - start_us) / 2 - kHeldBeforeMiddle_us;
  reading->flags = limit ? LoadcellPayload::at_limit : 0;
  done = false;
  return true;
}

uint16_t sensor_overruns() {
  noInterrupts();
  const uint16_t count = overruns;
  interrupts();
  return count;
}
#endif
