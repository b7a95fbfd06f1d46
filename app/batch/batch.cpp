#include "app/batch/batch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <mutex>
#include <new>

#include "acquisition/recording/mcap/format.h"
#include "app/batch/fingerprint.h"
#include "app/batch/inputs.h"
#include "app/in_parallel.h"

namespace searig::app {
namespace {

using nlohmann::json;
using std::chrono::steady_clock;

std::string duration_words(double seconds) {
  char text[40];
  if (seconds < 90)
    std::snprintf(text, sizeof text, "%.0f s", std::ceil(seconds));
  else if (seconds < 5400)
    std::snprintf(text, sizeof text, "%.0f min", std::ceil(seconds / 60));
  else
    std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
  return text;
}

/// How far the batch is. Time goes by bytes, for recordings differ in length.
class Progress {
 public:
  Progress(const Told& told, std::size_t count, std::uint64_t bytes)
      : told_(told), count_(count), bytes_(double(bytes)) {}

  void done(std::uint64_t bytes, bool failed, bool kept) {
    const std::scoped_lock lock(mutex_);
    ++done_, failed_ += failed;
    (kept ? kept_bytes_ : done_bytes_) += double(bytes);
    if (kept || !told_) return;
    const double left = bytes_ - kept_bytes_ - done_bytes_;
    const double taken_s = std::chrono::duration<double>(steady_clock::now() - start_).count();
    std::string words = std::to_string(done_) + " of " + std::to_string(count_) + " recordings";
    if (failed_ > 0) words += ", " + std::to_string(failed_) + " failed";
    if (done_bytes_ > 0)
      words += ", about " + duration_words(taken_s * left / done_bytes_) + " left";
    told_(words, bytes_ > 0 ? 1.0 - left / bytes_ : 1.0);
  }

 private:
  const Told& told_;
  std::mutex mutex_;
  steady_clock::time_point start_ = steady_clock::now();
  std::size_t count_, done_ = 0, failed_ = 0;
  double bytes_, kept_bytes_ = 0.0, done_bytes_ = 0.0;
};

Plan plan_of(const Batch& batch) {
  std::string paths;
  for (const std::string& path : batch.recordings) paths += path + '\n';
  return {batch.command, batch.settings, batch.recordings.size(),
          acquisition::mcap::crc32_of(paths), batch.shard};
}

Outcome attempt(const std::string& path, const std::function<Outcome(const std::string&)>& work) {
  std::string why;
  try {
    return work(path);
  } catch (const std::bad_alloc&) {
    why = path + ": does not fit into memory.";
  } catch (const std::exception& error) {
    why = error.what();
  }
  return {{{"name", name_of(path)}, {"path", path}, {"why", why}}, {}};
}

/// What a journal gives back: what is not finite is null, and no text is anything but UTF-8.
json as_read_back(const json& answer) {
  return json::parse(answer.dump(-1, ' ', false, json::error_handler_t::replace));
}

}  // namespace

std::vector<Outcome> run_batch(const Batch& batch,
                               const std::function<Outcome(const std::string&)>& work,
                               const Told& told) {
  std::vector<std::size_t> mine;
  for (std::size_t i = batch.shard.number - 1; i < batch.recordings.size(); i += batch.shard.of)
    mine.push_back(i);
  std::vector<Fingerprint> files(mine.size());
  in_parallel(mine.size(), batch.jobs,
              [&](std::size_t i) { files[i] = fingerprint_of(batch.recordings[mine[i]]); });
  std::uint64_t bytes = 0;
  for (const Fingerprint& file : files) bytes += file.bytes;

  const auto journal =
      batch.out ? std::make_unique<Journal>(*batch.out, plan_of(batch), batch.resume) : nullptr;
  Progress progress(told, mine.size(), bytes);
  std::vector<Outcome> outcomes(mine.size());
  std::exception_ptr stopped;
  std::mutex stopping;
  in_parallel(mine.size(), batch.jobs, [&](std::size_t i) {
    const std::string& path = batch.recordings[mine[i]];
    const Entry* kept = journal ? journal->find(path, files[i].text) : nullptr;
    if (kept && kept->index == mine[i]) {
      outcomes[i].answer = kept->answer;
      progress.done(files[i].bytes, false, true);
      return;
    }
    {
      const std::scoped_lock lock(stopping);
      if (stopped) return;
    }
    outcomes[i] = kept ? Outcome{kept->answer, {}} : attempt(path, work);
    outcomes[i].answer = as_read_back(outcomes[i].answer);
    if (journal) {
      outcomes[i].words.clear();
      try {
        journal->append({mine[i], path, files[i].text, outcomes[i].answer});
      } catch (...) {
        const std::scoped_lock lock(stopping);
        if (!stopped) stopped = std::current_exception();
      }
    }
    progress.done(files[i].bytes, outcomes[i].failed(), false);
  });
  if (stopped) std::rethrow_exception(stopped);
  return outcomes;
}

std::size_t failed_of(const std::vector<Outcome>& outcomes) {
  return std::size_t(std::ranges::count_if(outcomes, &Outcome::failed));
}

}  // namespace searig::app
