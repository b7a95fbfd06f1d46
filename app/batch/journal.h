// What a batch has done so far, in one file that outlives a kill.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace searig::app {

/// Shard `number` of `of`, from 1.
struct Shard {
  std::size_t number = 1, of = 1;
};

/// What is to be done, and how: what two runs must agree in so that one may go on with the other.
struct Plan {
  std::string command;      ///< "evaluate"
  nlohmann::json settings;  ///< all that decides the answers beside the recordings themselves
  std::size_t recordings = 0;
  std::uint32_t list = 0;  ///< CRC-32 of their paths, in order
  Shard shard;
};

/// The answer for one recording.
struct Entry {
  std::size_t index = 0;  ///< in the plan
  std::string path;
  std::string fingerprint;
  nlohmann::json answer;
  bool failed() const { return answer.contains("why"); }
};

/// A journal as it lies in a folder: one line of JSON for each run's plan, then one for each
/// recording that was done under it. The last line may be torn.
struct JournalText {
  Plan plan;                      ///< the last
  std::vector<Entry> entries;     ///< of runs with the last plan's command and settings
  std::uint64_t whole_bytes = 0;  ///< of the lines that are whole
};

inline constexpr const char* journal_name = "batch.jsonl";

/// Throws InputError where there is no journal in the folder, or it is none.
JournalText read_journal(const std::filesystem::path& folder);

/// The journal of a batch that runs. Only one process at a time has it.
class Journal {
 public:
  /// Makes folder and journal, or goes on with what is there if `resume` says so. Throws
  /// std::runtime_error with one sentence where there is one already and `resume` does not say so,
  /// where another process has it, or where it cannot be written.
  Journal(const std::filesystem::path& folder, const Plan& plan, bool resume);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// What an earlier run answered for this path, when its files were the same; else nullptr. What
  /// failed is not kept: it is tried again.
  const Entry* find(const std::string& path, const std::string& fingerprint) const;

  /// From any thread. In the system's hands when it returns, so that a kill leaves it whole; on the
  /// disk within a second.
  void append(const Entry& entry);

 private:
  void write_line(const nlohmann::json& line);

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::map<std::string, Entry> kept_;
  std::mutex mutex_;
  std::int64_t synced_at_s_ = 0;
};

}  // namespace searig::app
