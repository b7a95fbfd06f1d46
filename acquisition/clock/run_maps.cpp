#include "acquisition/clock/run_maps.h"

namespace searig::acquisition {
namespace {

constexpr double kPiece = 10.0;  // s, of a clock that runs unevenly

RunMap one_line(const DeviceTrack& device, const DeviceTrack& module) {
  const double at = device.line.delay.at;
  const double rate = device.line.rate() / module.line.rate();
  return {device.run.first, device.run.last, rate, module.device(device.host(at)) - rate * at};
}

}  // namespace

RunMap as_it_is(const Run& run) {
  return {run.first, run.last, 1.0, 0.0};
}

std::vector<RunMap> through_host(const std::vector<double>& t_s, const DeviceTrack& device,
                                 const DeviceTrack& module) {
  if (!device.bent() && !module.bent()) return {one_line(device, module)};
  std::vector<RunMap> pieces;
  for (std::size_t first = device.run.first; first < device.run.last;) {
    std::size_t last = first + 1;
    while (last < device.run.last && t_s[last] < t_s[first] + kPiece) ++last;
    const double from = t_s[first], to = from + kPiece;
    const double module_s = module.device(device.host(from));
    const double rate = (module.device(device.host(to)) - module_s) / (to - from);
    pieces.push_back({first, last, rate, module_s - rate * from});
    first = last;
  }
  return pieces;
}

}  // namespace searig::acquisition
