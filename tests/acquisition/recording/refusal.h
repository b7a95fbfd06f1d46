// The sentence that bad input is refused with.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "acquisition/error.h"

namespace searig::acquisition {

/// The sentence that `work` is refused with; fails the test where it is not.
template <typename Work>
std::string refusal(Work work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

inline bool says(const std::string& sentence, const std::string& part) {
  return sentence.find(part) != std::string::npos;
}

}  // namespace searig::acquisition
