#include "app/desktop/content.h"

#include <optional>
#include <utility>

namespace searig::app::desktop {
namespace {

class SimulatedContent : public Content {
 public:
  QString name() const override { return QStringLiteral("Simulated rig"); }
  const acquisition::Recording& recording() const override { return rig_.recording(); }
  const acquisition::ClockMap& clock() const override { return rig_.clock(); }
  const History& history() const override { return rig_.history(); }
  bool live() const override { return true; }
  void run_until(double seconds) override { rig_.run_until(seconds); }

 private:
  LiveRig rig_;
};

/// The libraries' notes begin small and end without a stop.
QString sentence(QString words) {
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words + QStringLiteral(". ");
}

class RecordedContent : public Content {
 public:
  RecordedContent(Session session, const std::optional<estimator::Model>& model)
      : session_(std::move(session)) {
    const auto evaluation = evaluate_session(session_, model);
    history_ = history_of(session_.signals, evaluation);
    for (const auto& note : evaluation.notes) remark_ += sentence(QString::fromStdString(note));
  }

  QString name() const override { return QString::fromStdString(session_.recording.name); }
  const acquisition::Recording& recording() const override { return session_.recording; }
  const acquisition::ClockMap& clock() const override { return session_.clock; }
  const History& history() const override { return history_; }
  QString remark() const override { return remark_; }

 private:
  Session session_;
  History history_;
  QString remark_;
};

}  // namespace

std::unique_ptr<Content> simulated_rig() {
  return std::make_unique<SimulatedContent>();
}

std::unique_ptr<Content> open_recording(const std::filesystem::path& folder) {
  return std::make_unique<RecordedContent>(open_session(folder), find_model(folder, std::nullopt));
}

}  // namespace searig::app::desktop
