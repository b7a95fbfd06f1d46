// What is in view, as the next session takes it up again.
#include <QStringList>
#include <array>

#include "app/desktop/replay/history_view.h"
#include "app/desktop/replay/replay_page.h"

namespace searig::app::desktop {

QString ReplayPage::view_in_words() const {
  if (!session_) return {};
  const auto said = [](const std::optional<double>& t_s) {
    return t_s ? QString::number(*t_s, 'g', 15) : QStringLiteral("-");
  };
  const Cursors& cursors = view_->cursors();
  return QStringList{said(view_->range().low), said(view_->range().high), said(cursors.a_s),
                     said(cursors.b_s)}
      .join(QLatin1Char(' '));
}

/// Words that say no view change nothing.
void ReplayPage::take_view(const QString& words) {
  const QStringList parts = words.split(QLatin1Char(' '));
  if (!session_ || parts.size() != 4) return;
  std::array<std::optional<double>, 4> times;
  for (int i = 0; i < 4; ++i) {
    bool is_number = false;
    const double t_s = parts[i].toDouble(&is_number);
    if (is_number) times[std::size_t(i)] = t_s;
  }
  const auto& [low, high, a_s, b_s] = times;
  if (low && high && *high > *low) view_->show_range({*low, *high});
  view_->set_cursors({a_s, b_s});
}

}  // namespace searig::app::desktop
