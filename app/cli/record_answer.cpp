#include "app/cli/record_answer.h"

#include <cstdio>

namespace searig::app {
namespace {

using acquisition::RecorderState;

std::string device_line(const char* name, const acquisition::WireCounters& counters) {
  char text[160];
  std::snprintf(text, sizeof text, "%s %llu, lost %llu, garbled %llu", name,
                static_cast<unsigned long long>(counters.samples),
                static_cast<unsigned long long>(counters.lost_samples),
                static_cast<unsigned long long>(acquisition::garbled(counters)));
  return text;
}

std::string clock_words(const RecorderState& state) {
  if (!state.clock) return "clocks not known yet";
  char text[80];
  std::snprintf(text, sizeof text, "clocks +-%.1f ms%s", 1e3 * state.clock->ci95_s,
                state.clock->trusted ? "" : ", NOT TRUSTED");
  return text;
}

nlohmann::json counters_json(const char* name, const acquisition::WireCounters& counters) {
  return {{"name", name},
          {"received", counters.samples},
          {"lost", counters.lost_samples},
          {"doubled", counters.doubled},
          {"garbled", acquisition::garbled(counters)},
          {"out_of_order", counters.out_of_order},
          {"restarts", counters.restarts}};
}

}  // namespace

std::string state_line(const RecorderState& state) {
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.1f s   ", state.seconds);
  return seconds + device_line("module", state.module) + "   " +
         device_line("load cell", state.loadcell) + "   " + clock_words(state);
}

nlohmann::json record_answer(const std::filesystem::path& file, const RecorderState& state) {
  nlohmann::json out = {
      {"format", "searig-record/1"},
      {"file", file.string()},
      {"seconds", state.seconds},
      {"bytes", state.bytes_written},
      {"streams",
       {counters_json("module", state.module), counters_json("loadcell", state.loadcell)}}};
  if (state.clock)
    out["loadcell_to_module"] = {{"rate", state.clock->rate},
                                 {"offset_s", state.clock->offset_s},
                                 {"ci95_s", state.clock->ci95_s},
                                 {"trusted", state.clock->trusted},
                                 {"why", state.clock->why}};
  return out;
}

}  // namespace searig::app
