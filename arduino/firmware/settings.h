// What is chosen when the sketch is built: here, or with -D on the compiler's command line.
#pragma once

#include <stdint.h>

// The load cell's converter: 1 an amplifier on an analogue pin, 0 an HX711.
#ifndef SEARIG_ANALOGUE
#define SEARIG_ANALOGUE 0
#endif

const uint16_t kFirmwareVersion = 1;
const uint16_t kRateHz = 50;
const uint32_t kBaud = 115200;

const uint8_t kHx711DataPin = 4;  // of D0 to D7, which share one pin-change interrupt
const uint8_t kHx711ClockPin = 5;
const uint8_t kAnalogueChannel = 0;  // A0
const uint8_t kAnalogueBurst = 16;   // conversions summed into one reading

#if !defined(__AVR_ATmega328P__)
#error "Written for the ATmega328P: choose an Arduino Uno or Nano."
#endif
