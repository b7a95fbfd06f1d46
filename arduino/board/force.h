// The force at the simulated load cell, by a word on the command line.
#pragma once

#include <string_view>

#include "arduino/board/simulated_board.h"

namespace searig::board {

/// constant:N, sine:N,HZ[,N at rest], ramp:N_PER_S, or twin[:SEED]: what the simulated module's
/// lever does to it (searig-module with the same seed and the same --epoch plays the other end).
/// begin_s: the waveform's time at the board's start. Throws InputError.
Force parse_force(std::string_view word, double begin_s = 0.0);

}  // namespace searig::board
