#include "acquisition/recorder/file_thread.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "acquisition/recorder/priority.h"
#include "acquisition/source/source.h"

namespace searig::acquisition {
namespace {

using Clock = std::chrono::steady_clock;

Clock::duration seconds(double s) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
}

std::string too_full(const std::filesystem::path& path, std::uint64_t free, std::uint64_t least) {
  char words[160];
  std::snprintf(words, sizeof words,
                ": the disk has only %.2f GB left, and a recording wants %.2f GB.",
                1e-9 * double(free), 1e-9 * double(least));
  return path.string() + words;
}

/// The options, if the disk has room: asked before the file is made, so that none is left behind.
const FileOptions& with_room(const FileOptions& options) {
  const std::uint64_t free = free_bytes_beside(options.path);
  if (free < options.least_free_bytes)
    throw std::runtime_error(too_full(options.path, free, options.least_free_bytes));
  return options;
}

}  // namespace

FileThread::FileThread(const FileOptions& options)
    : options_(with_room(options)),
      file_(options.path),
      out_([this](std::string_view bytes) { file_.append(bytes); }, options.program,
           options.epoch_s),
      queue_(options.most_waiting) {
  bytes_written_ = file_.size();
  writer_ = std::thread([this] { write_all(); });
  syncer_ = std::thread([this] { sync_each_second(); });
}

FileThread::~FileThread() {
  if (writer_.joinable()) finish();
}

void FileThread::finish() {
  queue_.close();
  writer_.join();
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  ended_.notify_one();
  syncer_.join();
}

void FileThread::write_all() {
  prefer_this_thread();
  std::vector<Entry> entries;
  auto next = Clock::now();
  const auto clock_each = static_cast<long>(1.0 / options_.chunk_s);
  try {
    for (long chunk = 1; queue_.take_at(next += seconds(options_.chunk_s), entries); ++chunk) {
      for (const Entry& entry : entries) {
        write_entry(entry, out_);
        rolling_.take(entry);
      }
      if (chunk % clock_each == 0) estimate_clock();
      out_.file().end_chunk();
      bytes_written_ = file_.size();
      next = std::max(next, Clock::now() - seconds(options_.chunk_s));  // do not chase a stall
    }
    out_.file().add_metadata("searig", {{"program", options_.program}});
    out_.file().finish();
    bytes_written_ = file_.size();
  } catch (const std::exception& error) {
    fail(error.what());
    while (queue_.take_at(Clock::now() + seconds(options_.chunk_s), entries)) {
    }  // so that the queue does not fill until the recorder has noticed
  }
}

void FileThread::estimate_clock() {
  const auto map = rolling_.estimate();
  if (!map) return;
  out_.clock(host_now_s(), *map);
  const std::lock_guard lock(mutex_);
  clock_ = map;
}

void FileThread::sync_each_second() {
  for (bool last = false; !last;) {
    {
      std::unique_lock lock(mutex_);
      ended_.wait_for(lock, seconds(1.0), [this] { return done_; });
      last = done_;
    }
    try {
      file_.sync();
      if (!last) check_room();
    } catch (const std::exception& error) {
      fail(error.what());
    }
  }
}

void FileThread::check_room() {
  const std::uint64_t free = file_.free_bytes();
  if (free < options_.least_free_bytes)
    fail(too_full(options_.path, free, options_.least_free_bytes));
}

void FileThread::fail(const std::string& why) {
  const std::lock_guard lock(mutex_);
  if (failure_.empty()) failure_ = why;
}

std::string FileThread::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

std::optional<ClockMap> FileThread::clock() const {
  const std::lock_guard lock(mutex_);
  return clock_;
}

}  // namespace searig::acquisition
