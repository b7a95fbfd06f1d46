#include "tests/proving/score/overlap.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace searig::proving {
namespace {

using nlohmann::json;
using Channels = std::map<std::string, std::vector<double>>;
using Mask = std::vector<bool>;

void add_rate(Channels& c, const std::string& of, const std::string& name) {
  const auto &y = c[of], &t = c["t_s"];
  const std::size_t reach = std::max<std::size_t>(
      2, static_cast<std::size_t>(0.02 * static_cast<double>(t.size()) / (t.back() - t.front())));
  std::vector<double> rate(y.size(), 0.0);
  for (std::size_t i = reach; i + reach < y.size(); ++i)
    rate[i] = (y[i + reach] - y[i - reach]) / (t[i + reach] - t[i - reach]);
  c[name] = rate;
}

/// The module's channels under the names a tool may use for a region.
Channels read_channels(const std::filesystem::path& recording) {
  std::ifstream file(recording / "module.csv");
  std::string line, field;
  std::vector<std::string> names;
  Channels c;
  std::getline(file, line);
  for (std::stringstream header(line); std::getline(header, field, ',');) names.push_back(field);
  while (std::getline(file, line)) {
    std::stringstream row(line);
    for (const auto& name : names)
      std::getline(row, field, ','), c[name].push_back(std::atof(field.c_str()));
  }
  for (std::size_t i = 0; i < c["t_s"].size(); ++i)
    c["deflection_rad"].push_back(c["input_angle_rad"][i] - c["output_angle_rad"][i]);
  add_rate(c, "deflection_rad", "deflection_rate_rad_s");
  add_rate(c, "input_angle_rad", "input_velocity_rad_s");
  add_rate(c, "output_angle_rad", "output_velocity_rad_s");
  for (const double t : c["t_s"]) c["elapsed_s"].push_back(t - c["t_s"][0]);
  c["time_s"] = c["t_s"];
  return c;
}

const json& member(const json& place, const char* key) {
  static const json none = json::array();
  return place.is_object() && place.contains(key) && place[key].is_array() ? place[key] : none;
}

/// A tool may count seconds on the module's clock or from the first row: the better reading counts.
Mask within_intervals(const json& intervals, const std::vector<double>& t) {
  Mask mask(t.size(), false);
  for (const auto& i : intervals)
    for (std::size_t n = 0; n < t.size(); ++n) mask[n] = mask[n] || (t[n] >= i[0] && t[n] <= i[1]);
  return mask;
}

Mask within_regions(const json& regions, Channels& c) {
  Mask mask(c["t_s"].size(), false);
  for (const auto& r : regions) {
    const auto channel = c.find(r.value("channel", ""));
    if (channel == c.end()) continue;
    const double from = r.value("from", -1e300), to = r.value("to", 1e300);
    for (std::size_t n = 0; n < mask.size(); ++n)
      mask[n] = mask[n] || (channel->second[n] >= from && channel->second[n] <= to);
  }
  return mask;
}

double intersection_over_union(const Mask& a, const Mask& b) {
  double both = 0.0, either = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) both += a[n] && b[n], either += a[n] || b[n];
  return either > 0.0 ? both / either : 0.0;
}

double near_instants(const json& instants, const json& intervals, double zero_s) {
  double hit = 0.0;
  for (const double instant : instants)
    for (const auto& i : intervals)
      for (const double offset : {0.0, zero_s}) {
        const double from = i[0].get<double>() + offset, to = i[1].get<double>() + offset;
        const bool around = from <= instant && to >= instant && to - from <= 4.0;
        if (around || std::min(std::abs(from - instant), std::abs(to - instant)) <= 1.0) hit = 1.0;
      }
  return hit;
}

}  // namespace

std::optional<double> overlap(const json& truth, const json& answer,
                              const std::filesystem::path& recording) {
  const json &intervals = member(answer, "intervals_s"), &regions = member(answer, "regions");
  if (!truth.is_object() || truth.empty() || (intervals.empty() && regions.empty())) return {};
  Channels c = read_channels(recording);
  if (c["t_s"].empty()) return {};
  if (truth.contains("instants_s"))
    return near_instants(truth["instants_s"], intervals, c["t_s"][0]);
  const Mask wanted = truth.contains("intervals_s")
                          ? within_intervals(truth["intervals_s"], c["t_s"])
                          : within_regions(member(truth, "regions"), c);
  double best = intersection_over_union(wanted, within_regions(regions, c));
  for (const char* clock : {"t_s", "elapsed_s"})
    best = std::max(best, intersection_over_union(wanted, within_intervals(intervals, c[clock])));
  return best;
}

}  // namespace searig::proving
