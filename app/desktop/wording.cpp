#include "app/desktop/wording.h"

#include <algorithm>
#include <cmath>

#include "app/report/axis.h"

namespace searig::app::desktop {
namespace {

using acquisition::Recording;
using acquisition::Stream;

QString said(double value, int decimals) {
  return QString::fromStdString(number(value, decimals));
}

/// Three digits that count.
int decimals_for(double value) {
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(value) + 1e-12))), 0, 4);
}

QString stream_words(const QString& name, const Stream& stream) {
  const double seconds = stream.t_s.size() > 1 ? stream.t_s.back() - stream.t_s.front() : 0.0;
  const double rate =
      seconds > 0.0 ? static_cast<double>(stream.t_s.size() - 1 + stream.counts.lost) / seconds
                    : 0.0;
  QString words = QStringLiteral("%1: %2 rows at %3 Hz")
                      .arg(name, QString::number(stream.counts.received), said(rate, 1));
  const auto fault = [&words](std::size_t count, const char* kind) {
    if (count > 0) words += QStringLiteral(", %1 %2").arg(count).arg(QLatin1String(kind));
  };
  fault(stream.counts.lost, "lost");
  fault(stream.counts.doubled, "doubled");
  fault(stream.counts.garbled, "garbled");
  fault(stream.counts.out_of_order, "out of order");
  return words;
}

}  // namespace

QString stiffness_words(const History& history) {
  if (history.stiffness_nm_per_rad.empty()) return QStringLiteral("–");
  const double k = history.stiffness_nm_per_rad.back();
  return QStringLiteral("%1 N·m/rad").arg(said(k, decimals_for(k)));
}

QString spread_words(const History& history) {
  if (history.stiffness_sd_nm_per_rad.empty()) return {};
  const double half_width = 1.96 * history.stiffness_sd_nm_per_rad.back();
  if (!std::isfinite(half_width)) return QStringLiteral("the filter has not started");
  return QStringLiteral("±%1 by the filter's own account")
      .arg(said(half_width, decimals_for(history.stiffness_nm_per_rad.back())));
}

QString error_words(const History& history, bool live) {
  if (history.t_s.empty()) return QStringLiteral("–");
  const auto percent = error_percent(history, live ? history.t_s.back() - 20.0 : 0.0);
  return percent ? said(*percent, 1) + QStringLiteral(" %") : QStringLiteral("–");
}

QString weight_words(const History& history) {
  return history.weight.empty() ? QStringLiteral("–") : said(history.weight.back(), 2);
}

QString clock_words(const Recording& recording, const acquisition::ClockMap& clock) {
  if (recording.one_clock) return QStringLiteral("one clock");
  if (clock.why.empty()) return QStringLiteral("–");  // not synchronised yet
  return QStringLiteral("%1, ±%2 ms")
      .arg(clock.trusted ? QStringLiteral("trusted") : QStringLiteral("not trusted"),
           said(1e3 * clock.ci95_s, 1));
}

QString loss_words(const Recording& recording) {
  const auto& module = recording.module.counts;
  const auto& loadcell = recording.loadcell.counts;
  return QStringLiteral("%1 lost, %2 garbled")
      .arg(module.lost + loadcell.lost)
      .arg(module.garbled + loadcell.garbled);
}

QString status_words(const Recording& recording, const acquisition::ClockMap& clock) {
  QString words = stream_words(QStringLiteral("Module"), recording.module) +
                  QStringLiteral("    |    ") +
                  stream_words(QStringLiteral("load cell"), recording.loadcell);
  if (!recording.one_clock && !clock.why.empty()) {
    words += QStringLiteral("    |    the load cell's clock runs %1 ppm against the module's")
                 .arg(said(1e6 * (1.0 / clock.rate - 1.0), 1));
  }
  return words;
}

}  // namespace searig::app::desktop
