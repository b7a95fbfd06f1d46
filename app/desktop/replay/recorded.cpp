#include "app/desktop/replay/recorded.h"

#include <cctype>
#include <optional>
#include <utility>

namespace searig::app::desktop {
namespace {

/// The libraries' notes begin small and end without a stop.
std::string sentence(std::string words) {
  if (!words.empty()) words[0] = static_cast<char>(std::toupper(words[0]));
  return words + ". ";
}

}  // namespace

Recorded open_recorded(const std::filesystem::path& recording) {
  Recorded out{open_session(recording), {}, {}};
  const auto evaluation = evaluate_session(out.session, find_model(recording, std::nullopt));
  out.history = history_of(out.session.signals, evaluation);
  for (const auto& note : evaluation.notes) out.remark += sentence(note);
  return out;
}

}  // namespace searig::app::desktop
