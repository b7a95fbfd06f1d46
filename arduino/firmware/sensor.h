// The load cell's converter. hx711.cpp or analogue.cpp, as chosen in settings.h.
#pragma once

#include <stdint.h>

struct Reading {
  int32_t counts;
  uint32_t time_us;  // micros() at which it was taken
  uint8_t flags;     // of wire::LoadcellPayload::Flag
};

void sensor_begin();

// Called from the timer's interrupt, kRateHz times in a second.
void sensor_on_tick();

// Called as often as the loop comes round; never waits.
void sensor_poll();

// Whether an interrupt has left something for sensor_poll() or sensor_due().
bool sensor_has_news();

// Whether a reading is due to be sent, and which: once for each tick.
bool sensor_due(Reading* reading);

// Ticks so far whose reading was not fetched in time.
uint16_t sensor_overruns();
