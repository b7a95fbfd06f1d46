#include "acquisition/clock/device_clock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace searig::acquisition {
namespace {

/// How many rows on either side of a step back must agree that the device began anew.
constexpr std::size_t kWitnesses = 8;

/// Where counters wrap, s: 16 and 32 bits of ms and of us, and their sign bits.
constexpr std::array kWraps = {65.536, 32.768, 4294.967296, 2147.483648, 4294967.296, 2147483.648};

/// The steps forward of rows as they come, sorted.
std::vector<double> sorted_steps(std::span<const double> t) {
  std::vector<double> steps;
  steps.reserve(t.size());
  for (std::size_t i = 1; i < t.size(); ++i)
    if (t[i] > t[i - 1]) steps.push_back(t[i] - t[i - 1]);
  std::sort(steps.begin(), steps.end());
  return steps;
}

/// Samples missing in the gaps of a rising clock. Only a device that keeps a beat says so: where
/// the middle half of its steps differ by more than a quarter, a long step is just a long step.
std::size_t missing_in_gaps(std::span<const double> t) {
  const std::vector<double> steps = sorted_steps(t);
  if (steps.size() < 3) return 0;
  const double step = steps[steps.size() / 2];
  if (steps[3 * steps.size() / 4] - steps[steps.size() / 4] > 0.25 * step) return 0;
  std::size_t missing = 0;
  for (auto gap = std::upper_bound(steps.begin(), steps.end(), 1.5 * step); gap != steps.end();
       ++gap)
    missing += static_cast<std::size_t>(std::lround(*gap / step)) - 1;
  return missing;
}

/// What a step back from `before` to `after` adds to the clock if it is a counter's wrap, else 0.
/// A counter is caught within 50 samples, or a second, of either end.
double wrap_length(double before, double after, double step) {
  const double near = std::max(1.0, 50.0 * step);
  for (const double wrap : kWraps)
    for (const double begin : {0.0, -0.5 * wrap})  // unsigned counters, and signed ones
      if (near < 0.1 * wrap && before > begin + wrap - near && before < begin + wrap + step &&
          after >= begin && after < begin + near)
        return wrap;
  return 0.0;
}

bool begins_anew(std::span<const double> t, std::span<const double> host, std::size_t row) {
  if (!host.empty() && host[row] < host[row - 1]) return false;
  const auto before = t.subspan(row - std::min(row, kWitnesses), std::min(row, kWitnesses));
  const auto after = t.subspan(row + 1, std::min(t.size() - row - 1, kWitnesses));
  const auto later =
      std::count_if(before.begin(), before.end(), [&](double earlier) { return earlier > t[row]; });
  const auto higher =
      std::count_if(after.begin(), after.end(), [&](double next) { return next > t[row]; });
  const auto still_lower =
      std::count_if(after.begin(), after.end(), [&](double next) { return next < t[row - 1]; });
  return after.size() >= 3 && later == std::ssize(before) && higher == std::ssize(after) &&
         still_lower == std::ssize(after);
}

/// How long the longest part of t that never steps back is.
std::size_t longest_rising(std::span<const double> t) {
  std::vector<double> tails;  // tails[n]: lowest end of a rising part of n + 1 rows
  for (const double value : t) {
    const auto place = std::upper_bound(tails.begin(), tails.end(), value);
    if (place == tails.end())
      tails.push_back(value);
    else
      *place = value;
  }
  return tails.size();
}

/// Frames that are missing between two seq numbers; 0 where seq began anew.
std::size_t missing_between(double before, double after) {
  for (const double wrap : {0.0, 256.0, 65536.0, 4294967296.0}) {
    const double step = after - before + wrap;
    if (step > 0.0 && step < 30000.0) return static_cast<std::size_t>(step) - 1;
  }
  return 0;
}

/// A garbled time ends up far from all others, at an end of the run where it was not received.
void leave_out_astray(ClockedRows& rows, std::span<const double> t, std::vector<std::size_t>& order,
                      std::size_t end) {
  const double apart = std::max(1.0, 100.0 * median_step(t));
  const std::size_t first_received = *std::min_element(order.begin(), order.end());
  while (order.size() > 2 && order.back() != end - 1 &&
         t[order.back()] - t[order[order.size() - 2]] > apart) {
    order.pop_back();
    ++rows.astray;
  }
  while (order.size() > 2 && order.front() != first_received && t[order[1]] - t[order[0]] > apart) {
    order.erase(order.begin());
    ++rows.astray;
  }
}

/// Rows [begin, end) of one run, in order of their clock, into `rows`.
void append_run(ClockedRows& rows, std::span<const double> t, std::span<const double> seq,
                std::size_t begin, std::size_t end) {
  std::vector<std::size_t> order(end - begin);
  std::iota(order.begin(), order.end(), begin);
  const auto older = [&](std::size_t a, std::size_t b) { return t[a] < t[b]; };
  if (!std::is_sorted(order.begin(), order.end(), older)) {
    rows.misplaced += order.size() - longest_rising(t.subspan(begin, end - begin));
    std::stable_sort(order.begin(), order.end(), older);
    leave_out_astray(rows, t, order, end);
  }

  const std::size_t first = rows.order.size();
  for (const std::size_t row : order) {
    const bool seen =
        rows.order.size() > first &&
        (t[row] == rows.t_s.back() || (!seq.empty() && seq[row] == seq[rows.order.back()]));
    if (seen) {
      ++rows.doubled;
      continue;
    }
    if (!seq.empty() && rows.order.size() > first)
      rows.lost += missing_between(seq[rows.order.back()], seq[row]);
    rows.order.push_back(row);
    rows.t_s.push_back(t[row]);
  }
  if (seq.empty()) rows.lost += missing_in_gaps(std::span(rows.t_s).subspan(first));
}

}  // namespace

double median_step(std::span<const double> t_s) {
  const std::vector<double> steps = sorted_steps(t_s);
  return steps.empty() ? 0.0 : steps[steps.size() / 2];
}

ClockedRows read_device_clock(std::span<const double> t_s, std::span<const double> host_s,
                              std::span<const double> seq) {
  ClockedRows rows;
  const double step = median_step(t_s);
  std::vector<double> t(t_s.begin(), t_s.end());
  std::vector<std::size_t> runs{0};
  const auto not_rising = [&](std::size_t row) {
    if (rows.first_not_rising == 0) rows.first_not_rising = row;
  };
  double wrapped = 0.0;  // what the wraps so far add
  for (std::size_t row = 1; row < t.size(); ++row) {
    if (t_s[row] < t_s[row - 1]) {
      const double wrap = wrap_length(t_s[row - 1], t_s[row], step);
      wrapped += wrap;
      if (wrap == 0.0 && begins_anew(t_s, host_s, row)) {
        runs.push_back(row);
        wrapped = 0.0;
      } else if (wrap == 0.0) {
        ++rows.out_of_order;
        not_rising(row);
      }
    }
    if (t_s[row] == t_s[row - 1]) not_rising(row);
    t[row] = t_s[row] + wrapped;
  }
  runs.push_back(t.size());
  for (std::size_t run = 0; run + 1 < runs.size(); ++run) {
    if (run > 0) rows.restarts.push_back(rows.order.size());
    append_run(rows, t, seq, runs[run], runs[run + 1]);
  }
  return rows;
}

}  // namespace searig::acquisition
