// searig's load cell: an Arduino Uno or Nano that reads a load cell 50 times in a second, stamps
// each reading where it was taken, and sends it to the host. Wiring and protocol: docs/rig.md.
//
// settings.h chooses the converter. Open this folder in the Arduino IDE, or build it with CMake.

#include <avr/sleep.h>

#include "line.h"
#include "sensor.h"
#include "settings.h"
#include "store.h"

using namespace searig;

static Settings settings;

static Reading reading;
static bool reading_waits = false;
static uint16_t unsent = 0;  // readings that found no room on the line until the next was due

static wire::PingPayload pong;
static bool pong_waits = false;
static bool identity_waits = true;

ISR(TIMER1_COMPA_vect) {
  sensor_on_tick();
}

static void start_timer() {
  noInterrupts();
  TCCR1A = 0;
  TCCR1B = _BV(WGM12) | _BV(CS11);  // counts F_CPU / 8 up to OCR1A, then from 0
  TCNT1 = 0;
  OCR1A = F_CPU / 8 / kRateHz - 1;
  TIMSK1 = _BV(OCIE1A);
  interrupts();
}

static bool send_reading() {
  wire::LoadcellPayload payload;
  payload.counts = reading.counts;
  payload.flags = reading.flags;
  payload.overruns = sensor_overruns() + unsent;
  const uint32_t age_us = micros() - reading.time_us;
  payload.age_us = age_us < UINT16_MAX ? age_us : UINT16_MAX;
  uint8_t bytes[wire::LoadcellPayload::kSize];
  payload.write(bytes);
  return line_send(wire::Type::loadcell_sample, reading.time_us, bytes, sizeof bytes);
}

static bool send_identity() {
  wire::IdentityPayload identity;
  identity.kind =
      SEARIG_ANALOGUE ? wire::DeviceKind::loadcell_analogue : wire::DeviceKind::loadcell_hx711;
  identity.firmware_version = kFirmwareVersion;
  identity.rate_mhz = kRateHz * 1000UL;
  memcpy(identity.name, settings.name, sizeof identity.name);
  identity.tare_counts = settings.calibration.tare_counts;
  identity.newton_per_count = settings.calibration.newton_per_count;
  identity.gear_ratio = 0;
  uint8_t bytes[wire::IdentityPayload::kSize];
  identity.write(bytes);
  return line_send(wire::Type::identity, micros(), bytes, sizeof bytes);
}

// Only onto an idle line, so that the time in it is that at which it leaves.
static bool send_pong() {
  if (!line_idle()) return false;
  uint8_t bytes[wire::PingPayload::kSize];
  pong.write(bytes);
  return line_send(wire::Type::pong, micros(), bytes, sizeof bytes);
}

static void answer(const Request& request) {
  switch (request.type) {
    case wire::Type::ping:
      pong = wire::PingPayload::read(request.payload);
      pong.received_us = request.received_us;
      pong_waits = true;
      return;
    case wire::Type::set_calibration:
      settings.calibration = wire::CalibrationPayload::read(request.payload);
      store_write(settings);
      break;
    case wire::Type::set_name:
      memcpy(settings.name, request.payload, sizeof settings.name);
      store_write(settings);
      break;
    case wire::Type::identify:
      break;
    default:
      return;
  }
  identity_waits = true;
}

// Sleeps until the next interrupt: a byte from the host, the sensor, a tick, or the millisecond's.
// What comes between the question and the sleep still ends it, as interrupts are let in by the same
// instruction that precedes it.
static void rest() {
  noInterrupts();
  if (line_heard() || sensor_has_news() || reading_waits || pong_waits || identity_waits) {
    interrupts();
    return;
  }
  sleep_enable();
  interrupts();
  sleep_cpu();
  sleep_disable();
}

void setup() {
  set_sleep_mode(SLEEP_MODE_IDLE);
  settings = store_read();
  line_begin(store_count_boot());
  sensor_begin();
  start_timer();
}

void loop() {
  Request request;
  if (line_receive(&request)) answer(request);
  sensor_poll();
  Reading next;
  if (sensor_due(&next)) {
    if (reading_waits) ++unsent;
    reading = next;
    reading_waits = true;
  }
  if (reading_waits && send_reading()) reading_waits = false;
  if (pong_waits && send_pong()) pong_waits = false;
  if (identity_waits && send_identity()) identity_waits = false;
  rest();
}
