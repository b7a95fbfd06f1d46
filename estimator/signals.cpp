#include "estimator/signals.h"

namespace searig::estimator {

ModuleSignals rows_of(const ModuleSignals& module, std::size_t from, std::size_t to) {
  const auto part = [=](const std::vector<double>& all) {
    if (all.size() < to) return std::vector<double>();
    return std::vector<double>(all.begin() + std::ptrdiff_t(from),
                               all.begin() + std::ptrdiff_t(to));
  };
  ModuleSignals out;
  out.t_s = part(module.t_s);
  for (const auto& [name, values] : module_channels) out.*values = part(module.*values);
  return out;
}

}  // namespace searig::estimator
