// One piece of work for each of many recordings: on all cores, in parts, on after an interruption.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/batch/journal.h"

namespace searig::app {

struct Batch {
  std::string command;      ///< "evaluate" or "diagnose"
  nlohmann::json settings;  ///< all that decides the answers beside the recordings themselves
  std::vector<std::string> recordings;
  Shard shard = {};   ///< the recordings number, number + of, ... of the list
  unsigned jobs = 0;  ///< 0: one for each core
  std::optional<std::filesystem::path> out = {};  ///< where what is done is kept
  bool resume = false;
};

/// What came of a recording: for machines, and in words. The answer of one that failed is its name,
/// path and "why".
struct Outcome {
  nlohmann::json answer;
  std::string words;
  bool failed() const { return answer.contains("why"); }
};

/// Told after each recording, from one thread at a time: how much is done, of 1, and in words, with
/// an estimate of the time left.
using Told = std::function<void(const std::string& doing, double share)>;

/// Calls work(path) for each recording of the shard and returns the outcomes in the list's order:
/// the same whatever the number of jobs, and whether some were done by an earlier run. What throws
/// has failed, with its sentence. Only outcomes are kept in memory; words only where nothing goes
/// to a folder. Throws std::runtime_error where the journal cannot be written.
std::vector<Outcome> run_batch(const Batch& batch,
                               const std::function<Outcome(const std::string&)>& work,
                               const Told& told = {});

/// How many have failed.
std::size_t failed_of(const std::vector<Outcome>& outcomes);

}  // namespace searig::app
