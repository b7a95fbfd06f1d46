#include "arduino/board/force.h"

#include <charconv>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "acquisition/error.h"
#include "estimator/twin/twin.h"

namespace searig::board {
namespace {

[[noreturn]] void refuse(std::string_view word) {
  throw acquisition::InputError(
      "'" + std::string(word) +
      "' is no force: constant:N, sine:N,HZ[,N], ramp:N_PER_S, twin[:SEED]");
}

std::vector<double> numbers_in(std::string_view text, std::string_view word) {
  std::vector<double> numbers;
  while (!text.empty()) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{}) refuse(word);
    numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!text.empty() && text.front() != ',') refuse(word);
    if (!text.empty()) text.remove_prefix(1);
  }
  return numbers;
}

Force twin_force(std::uint64_t seed, double begin_s) {
  const auto twin = std::make_shared<estimator::twin::Twin>(estimator::twin::Parameters{}, seed);
  return [twin, begin_s](double true_s) {
    twin->advance_to(begin_s + true_s);
    return twin->read_loadcell().force_n;
  };
}

}  // namespace

Force parse_force(std::string_view word, double begin_s) {
  const std::size_t colon = std::min(word.find(':'), word.size());
  const std::string_view kind = word.substr(0, colon);
  const auto n = numbers_in(word.substr(std::min(colon + 1, word.size())), word);
  if (kind == "constant" && n.size() == 1) return [n](double) { return n[0]; };
  if (kind == "ramp" && n.size() == 1) {
    return [n, begin_s](double true_s) { return n[0] * (begin_s + true_s); };
  }
  if (kind == "sine" && (n.size() == 2 || n.size() == 3)) {
    const double rest = n.size() == 3 ? n[2] : 0.0;
    return [n, rest, begin_s](double true_s) {
      return rest + n[0] * std::sin(2.0 * std::numbers::pi * n[1] * (begin_s + true_s));
    };
  }
  if (kind == "twin" && n.size() <= 1) {
    return twin_force(n.empty() ? 1 : static_cast<std::uint64_t>(n[0]), begin_s);
  }
  refuse(word);
}

}  // namespace searig::board
