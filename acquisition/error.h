// Bad input, said once in one sentence that names the place.
#pragma once

#include <stdexcept>
#include <string>

namespace searig::acquisition {

/// Thrown where a file cannot be used. what() is one sentence for people: file, line, column, cause.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace searig::acquisition
