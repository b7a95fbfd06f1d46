#include "app/session/merge.h"

#include <algorithm>
#include <stdexcept>

namespace searig::app {
namespace {

using estimator::ModuleSignals;

void append(std::vector<double>& to, const std::vector<double>& values) {
  to.insert(to.end(), values.begin(), values.end());
}

/// Channels that all have go in; one that only some have is told of.
void append_channels(Merged& out, const std::vector<const Session*>& sessions) {
  for (const auto& [name, values] : estimator::module_channels) {
    const auto lacks = [values = values](const Session* s) {
      return (s->signals.module.*values).empty();
    };
    if (std::ranges::none_of(sessions, lacks)) {
      for (const Session* s : sessions)
        append(out.signals.module.*values, s->signals.module.*values);
    } else if (!std::ranges::all_of(sessions, lacks)) {
      const Session* first = *std::ranges::find_if(sessions, lacks);
      out.notes.push_back(std::string(name) + " is left out: " + first->recording.name +
                          " does not have it");
    }
  }
}

/// Load-cell samples beyond the module's own would run into the next recording.
void append_loadcell(Merged& out, const estimator::Signals& from, double shift_s) {
  for (std::size_t i = 0; i < from.loadcell.t_s.size(); ++i) {
    const double t = from.loadcell.t_s[i];
    if (t < from.module.t_s.front() || t > from.module.t_s.back()) continue;
    out.signals.loadcell.t_s.push_back(t + shift_s);
    out.signals.loadcell.torque_nm.push_back(from.loadcell.torque_nm[i]);
  }
}

}  // namespace

double seconds_of(const std::vector<Part>& parts) {
  double sum = 0.0;
  for (const Part& part : parts) sum += part.to_s - part.from_s;
  return sum;
}

Merged merge(const std::vector<const Session*>& sessions) {
  Merged out;
  for (const Session* session : sessions) {
    if (session->signals.module.t_s.empty())
      throw std::invalid_argument(session->recording.name + " holds no sample of the module");
  }
  if (sessions.size() == 1) {
    out.signals = sessions.front()->signals;
    const auto& t = out.signals.module.t_s;
    out.parts.push_back({sessions.front()->recording.name, t.front(), t.back()});
    return out;
  }
  double next_s = 0.0;
  for (const Session* session : sessions) {
    const estimator::Signals& from = session->signals;
    const double shift_s = next_s - from.module.t_s.front();
    for (const double t : from.module.t_s) out.signals.module.t_s.push_back(t + shift_s);
    append_loadcell(out, from, shift_s);
    out.signals.clock_ci95_s = std::max(out.signals.clock_ci95_s, from.clock_ci95_s);
    const double end_s = from.module.t_s.back() + shift_s;
    out.parts.push_back({session->recording.name, next_s, end_s});
    out.signals.part_starts_s.push_back(next_s);
    next_s = end_s + gap_between_s;
  }
  out.signals.gear_ratio = sessions.front()->signals.gear_ratio;
  append_channels(out, sessions);
  return out;
}

}  // namespace searig::app
