// Many pieces of work: the same answers with any number of jobs, shards and interruptions.
#include "app/batch/batch.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mutex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "app/batch/merge.h"
#include "app/batch/summary.h"
#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// What a real command answers, in short. Every seventh recording is bad.
Outcome answer_for(const std::string& path) {
  const std::size_t size = fs::file_size(path);
  if (size % 7 == 0) throw std::runtime_error(path + ": is bad.");
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {{{"name", fs::path(path).stem().string()},
           {"path", path},
           {"seconds", double(size) / 3.0},
           {"models",
            {{"best_fit",
              {{"k_nm_per_rad", 40.0 + 0.1 * double(size)},
               {"error_percent", size % 2 ? none : 7.0}}}}},
           {"notes", {"left out: " + std::to_string(size)}}},
          "words of " + path + "\n"};
}

class RunBatch : public testing::Test {
 protected:
  static constexpr std::size_t count = 20;

  RunBatch() {
    for (std::size_t i = 0; i < count; ++i)
      paths_.push_back(
          folder_.write("r" + std::to_string(i) + ".mcap", std::string(i + 1, 'x')).string());
  }

  Batch batch(const std::string& out = "") const {
    Batch batch{.command = "evaluate", .settings = {{"initial_k", 40}}, .recordings = paths_};
    if (!out.empty()) batch.out = folder_.path() / out;
    return batch;
  }

  /// Runs it and counts in done_ which recordings were worked on.
  Summary run(const Batch& batch) {
    done_.clear();
    const auto outcomes = run_batch(batch, [&](const std::string& path) {
      {
        const std::scoped_lock lock(mutex_);
        done_.insert(path);
      }
      return answer_for(path);
    });
    Summary summary{batch.command, {}};
    for (const Outcome& outcome : outcomes) summary.answers.push_back(outcome.answer);
    return summary;
  }

  static std::string bytes_of(const Summary& summary) {
    return answer_of(summary).dump(2) + csv_of(summary) + page_of(summary).text();
  }

  std::string whole() { return bytes_of(run(batch())); }

  std::string journal_of(const std::string& out) const {
    std::ifstream file(folder_.path() / out / journal_name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TemporaryFolder folder_;
  std::vector<std::string> paths_;
  std::set<std::string> done_;
  std::mutex mutex_;
};

TEST_F(RunBatch, AnswersInOrderWithAnyNumberOfJobs) {
  Batch one = batch(), many = batch();
  one.jobs = 1, many.jobs = 5;
  const Summary answers = run(one);
  EXPECT_EQ(answers.answers.size(), count);
  EXPECT_EQ(answers.answers[3].at("name"), "r3");
  EXPECT_EQ(answers.answers[6].at("why"), paths_[6] + ": is bad.");
  EXPECT_EQ(bytes_of(answers), bytes_of(run(many)));
}

TEST_F(RunBatch, CountsTheFailedAndTellsHowFarItIs) {
  double last = 0.0;
  std::string words;
  Batch with = batch();
  with.jobs = 1;
  const auto outcomes = run_batch(with, answer_for, [&](const std::string& doing, double share) {
    EXPECT_GT(share, last);
    last = share, words = doing;
  });
  EXPECT_EQ(failed_of(outcomes), 2u);
  EXPECT_DOUBLE_EQ(last, 1.0);
  EXPECT_TRUE(words.starts_with("20 of 20 recordings, 2 failed")) << words;
}

TEST_F(RunBatch, GoesOnAfterATornLineWithTheSameBytes) {
  Batch out = batch("out");
  out.jobs = 1;
  run(out);
  // As a kill leaves it: the plan, seven answers, and half of one more.
  const std::string journal = journal_of("out");
  std::size_t end = 0;
  for (int line = 0; line < 8; ++line) end = journal.find('\n', end) + 1;
  fs::resize_file(folder_.path() / "out" / journal_name, end + 30);

  Batch again = batch("out");
  again.resume = true;
  const std::string resumed = bytes_of(run(again));
  EXPECT_EQ(done_.size(), count - 6);  // of the seven one had failed: it is tried again
  EXPECT_FALSE(done_.contains(paths_[0]));
  EXPECT_EQ(resumed, whole());
  std::istringstream lines(journal_of("out"));
  for (std::string line; std::getline(lines, line);) EXPECT_TRUE(json::accept(line)) << line;

  EXPECT_EQ(bytes_of(run(again)), whole());
  run(again);
  EXPECT_EQ(done_.size(), 2u);  // only what failed
}

TEST_F(RunBatch, DoesAgainWhatChanged) {
  run(batch("out"));
  folder_.write("r3.mcap", std::string(50, 'y'));
  Batch again = batch("out");
  again.resume = true;
  const Summary resumed = run(again);
  EXPECT_TRUE(done_.contains(paths_[3]));
  EXPECT_EQ(done_.size(), 3u);
  EXPECT_EQ(bytes_of(resumed), whole());

  again.settings["initial_k"] = 50;
  run(again);
  EXPECT_EQ(done_.size(), count);
}

TEST_F(RunBatch, KeepsWhatIsDoneWhenTheListGrows) {
  Batch first = batch("out");
  first.recordings.erase(first.recordings.begin());
  run(first);
  Batch all = batch("out");
  all.resume = true;
  EXPECT_EQ(bytes_of(run(all)), whole());
  EXPECT_EQ(done_.size(), 3u);  // the new one, and two that failed
  EXPECT_EQ(bytes_of(merge_shards({folder_.path() / "out"})), whole());
}

TEST_F(RunBatch, DoesAgainWhatTheDiskHasSpoilt) {
  run(batch("out"));
  std::string journal = journal_of("out");
  journal[journal.find("\"fingerprint\"") + 1] = '\x01';
  folder_.write(std::string("out/") + journal_name, journal);
  Batch again = batch("out");
  again.resume = true;
  EXPECT_EQ(bytes_of(run(again)), whole());
  EXPECT_EQ(done_.size(), 3u);
}

TEST_F(RunBatch, LeavesAFinishedBatchAlone) {
  run(batch("out"));
  try {
    run(batch("out"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("--resume goes on"), std::string::npos);
  }
  folder_.write(std::string("out/") + journal_name, "something else\n");
  Batch again = batch("out");
  again.resume = true;
  EXPECT_THROW(run(again), std::runtime_error);
}

TEST_F(RunBatch, HasOneProcessAtATime) {
  const Journal first(folder_.path() / "out", {"evaluate", {}, 1, 0, {}}, false);
  try {
    const Journal second(folder_.path() / "out", {"evaluate", {}, 1, 0, {}}, true);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("another batch"), std::string::npos) << error.what();
  }
}

TEST_F(RunBatch, MergesShardsIntoTheSameBytes) {
  std::vector<fs::path> folders;
  for (std::size_t i = 1; i <= 8; ++i) {
    Batch shard = batch("shard" + std::to_string(i));
    shard.shard = {i, 8};
    run(shard);
    EXPECT_EQ(done_.size(), i <= 4 ? 3u : 2u);
    folders.push_back(*shard.out);
  }
  std::swap(folders[0], folders[5]);
  EXPECT_EQ(bytes_of(merge_shards(folders)), whole());

  folders.pop_back();
  const std::string why = acquisition::refusal([&] { merge_shards(folders); });
  EXPECT_TRUE(acquisition::says(why, "2 of 20 recordings are not done yet")) << why;
  EXPECT_TRUE(acquisition::says(why, "shard 8/8")) << why;
}

TEST_F(RunBatch, RefusesShardsOfDifferentBatches) {
  Batch one = batch("one"), other = batch("other");
  one.shard = {1, 2}, other.shard = {2, 2};
  other.settings["initial_k"] = 1;
  run(one), run(other);
  const std::string why = acquisition::refusal([&] { merge_shards({*one.out, *other.out}); });
  EXPECT_TRUE(acquisition::says(why, "another setting")) << why;
}

TEST_F(RunBatch, StopsWhereTheJournalCannotBeWritten) {
  Batch nowhere = batch("out");
  nowhere.out = "/proc/no/such/folder";
  EXPECT_THROW(run(nowhere), std::runtime_error);
  EXPECT_TRUE(done_.empty());
}

}  // namespace
}  // namespace searig::app
