#include "app/session/examine.h"

#include <utility>

namespace searig::app {

Examined examine(const std::vector<const Session*>& sessions, std::optional<estimator::Model> given,
                 const estimator::Progress& progress, const estimator::Method& method) {
  Examined out;
  Merged merged = merge(sessions);
  out.signals = std::move(merged.signals);
  out.parts = std::move(merged.parts);
  out.given = std::move(given);
  out.diagnosis = estimator::diagnose(out.signals, out.given, progress, method);
  auto& notes = out.diagnosis.notes;
  notes.insert(notes.end(), merged.notes.begin(), merged.notes.end());
  for (const Session* session : sessions) {
    if (const auto& cut_off = session->recording.cut_off; !cut_off.empty())
      notes.push_back(session->recording.name + ": " + cut_off);
    if (!session->clock.trusted) {
      notes.push_back("the clocks of " + session->recording.name +
                      " are not to be trusted: " + session->clock.why);
    }
    for (std::size_t i = 0; i < session->devices.size(); ++i)
      if (!session->devices[i].trusted)
        notes.push_back(session->recording.devices[i].stream.name + " of " +
                        session->recording.name +
                        " is not placed in time for sure: " + session->devices[i].why);
  }
  return out;
}

}  // namespace searig::app
