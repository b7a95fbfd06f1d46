#include "app/rig/live_verdict.h"

#include <cstdio>

namespace searig::app {
namespace {

using Report = acquisition::Listener::Report;

LiveVerdict away(const char* device, const Report& report) {
  const bool seen = report.counters.samples > 0;
  return {Trust::no, std::string(device) + (seen ? " UNPLUGGED" : " SILENT"),
          (report.trouble.empty() ? std::string("Nothing has come from it yet") : report.trouble) +
              (seen ? "; it is taken up again as soon as it is back."
                    : "; look at its cable and its name.")};
}

std::string ms(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f ms", 1e3 * seconds);
  return text;
}

}  // namespace

LiveVerdict verdict_of(const LiveNews& news, bool has_model) {
  if (!news.module.connected) return away("MODULE", news.module);
  if (!news.loadcell.connected) return away("LOAD CELL", news.loadcell);
  if (news.module.counters.samples == 0) return away("MODULE", news.module);
  if (news.loadcell.counters.samples == 0) return away("LOAD CELL", news.loadcell);
  constexpr double settled_s = 10.0;
  if (!news.clock || (!news.clock->trusted && news.now_s < settled_s))
    return {Trust::unknown, "CLOCKS SETTLE", "Ten seconds of both devices tell how they stand."};
  if (!news.clock->trusted) return {Trust::no, "CLOCKS NOT TRUSTED", news.clock->why};
  if (!has_model)
    return {Trust::yes, "DATA TRUSTED",
            "Without a model of the drive there is no estimate; choose one before connecting."};
  return {Trust::yes, "DATA TRUSTED",
          "Both devices are heard, their clocks known to " + ms(news.clock->ci95_s) + "."};
}

std::string recording_words(const RecordingStatus& status) {
  const double rate = status.seconds > 1.0 ? double(status.bytes) / status.seconds : 0.0;
  char text[160];
  int end = std::snprintf(text, sizeof text, "%.1f s, %.1f MB; %.1f GB free", status.seconds,
                          1e-6 * double(status.bytes), 1e-9 * double(status.free_bytes));
  if (rate > 0.0)
    std::snprintf(text + end, sizeof text - std::size_t(end), ", enough for %.0f h",
                  double(status.free_bytes) / rate / 3600.0);
  return text;
}

}  // namespace searig::app
