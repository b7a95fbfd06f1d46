#include "acquisition/recording/hebilog/logs.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/recording/hebilog/channels.h"

namespace searig::acquisition::hebilog {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

bool take_feedback(Log& log, const Frame& frame) {
  std::vector<std::pair<Path, double>> row;
  const bool whole = read_message(
      frame.message,
      {is_message,
       [&](Path path, std::uint64_t v) {
         row.emplace_back(path, double(std::int64_t(v)));  // negative ones are 64 bits long
       },
       [&](Path path, double v) { row.emplace_back(path, v); }, [](Path, std::string_view) {}});
  const auto has = [&](Path path) {
    return std::ranges::find(row, path, &std::pair<Path, double>::first) != row.end();
  };
  if (!whole || !has(hardware_sent_us)) return false;
  log.log_us.push_back(frame.log_us);
  for (const auto& [path, value] : row) log.set(path, value);
  return true;
}

bool take_information(Log& log, const Frame& frame) {
  return read_message(frame.message, {is_message, [](Path, std::uint64_t) {}, [](Path, double) {},
                                      [&](Path path, std::string_view text) {
                                        log.texts[path] = std::string(text);
                                      }});
}

}  // namespace

void Log::set(Path path, double value) {
  std::vector<double>& values = fields[path];
  values.resize(log_us.size(), missing);
  values.back() = value;
}

const std::vector<double>& Log::field(Path path) {
  std::vector<double>& values = fields[path];
  values.resize(log_us.size(), missing);
  return values;
}

Logs read_logs(std::string_view bytes) {
  Logs logs;
  logs.damage = read_frames(bytes, [&](const Frame& frame) {
    if (frame.type == Frame::Type::feedback)
      return take_feedback(logs.by_address[frame.address], frame);
    if (frame.type == Frame::Type::information)
      return take_information(logs.by_address[frame.address], frame);
    return true;
  });
  std::erase_if(logs.by_address, [](const auto& log) { return log.second.log_us.size() < 2; });
  return logs;
}

Log& chosen(Logs& logs, std::optional<std::size_t> module) {
  const std::size_t all = logs.by_address.size();
  if (all == 0) throw InputError("holds no feedback of a HEBI module.");
  if (module.value_or(1) < 1 || module.value_or(1) > all)
    throw InputError("holds the logs of " + std::to_string(all) + " modules; there is no module " +
                     std::to_string(*module) + ".");
  if (!module && all > 1)
    throw InputError("holds the logs of " + std::to_string(all) +
                     " modules, and a recording is of one; --module 1 to " + std::to_string(all) +
                     " says which.");
  return std::next(logs.by_address.begin(), std::ptrdiff_t(module.value_or(1) - 1))->second;
}

}  // namespace searig::acquisition::hebilog
