// The simulated board heard by a decoder, all in simulated time: a minute takes a few seconds.
#pragma once

#include <vector>

#include "acquisition/wire/decoder.h"
#include "acquisition/wire/encode.h"
#include "arduino/board/simulated_board.h"

namespace searig::board {

inline std::filesystem::path firmware(const std::string& sensor) {
  return SEARIG_FIRMWARE_DIR "/loadcell-" + sensor + ".elf";
}

struct BoardRun {
  BoardRun(const BoardSettings& settings, Force force) : board(settings, std::move(force)) {}

  /// Runs on, byte by byte into the decoder, each arriving as its last bit is out.
  void run_until(double true_s) {
    board.run_until(true_s);
    for (const auto& sent : board.take_sent()) {
      decoder.push({&sent.byte, 1}, sent.true_s, messages);
    }
  }

  template <typename T>
  std::vector<T> all() const {
    std::vector<T> found;
    for (const auto& message : messages) {
      if (const T* one = std::get_if<T>(&message)) found.push_back(*one);
    }
    return found;
  }

  SimulatedBoard board;
  acquisition::Decoder decoder;
  std::vector<acquisition::Message> messages;
};

}  // namespace searig::board
