#include "app/rig/live_feed.h"

#include <chrono>
#include <utility>

#include "acquisition/source/decode.h"

namespace searig::app {
namespace {

using acquisition::Entry;
using acquisition::StreamId;
using Clock = std::chrono::steady_clock;

constexpr double look_every_s = 0.015;
constexpr double follow_every_s = 0.045;  // each time the last 50 ms are looked at again
constexpr double clocks_every_s = 1.0;
constexpr double unseen_s = 600.0;  // news that nobody took
constexpr std::size_t most_events = 1000, most_counts = 100'000;

}  // namespace

std::size_t LiveFeed::Inbox::push(std::vector<Entry>& batch) {
  std::vector<Entry> wanted;  // raw bytes and counters are for files
  for (Entry& entry : batch)
    if (!std::holds_alternative<acquisition::RawPiece>(entry) &&
        !std::holds_alternative<acquisition::CountersRow>(entry))
      wanted.push_back(std::move(entry));
  batch.clear();
  queue_.push(wanted, acquisition::must_come);
  return 0;  // what a view misses is lost to nobody
}

bool LiveFeed::Inbox::take(std::vector<Entry>& entries, double wait_s) {
  return queue_.take_at(Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(wait_s)),
                        entries);
}

LiveFeed::LiveFeed(std::shared_ptr<acquisition::Lines> lines, const FollowOptions& options)
    : lines_(std::move(lines)), follower_(options) {
  const auto listener = [&](acquisition::Line& line, auto calibration) {
    auto made = std::make_shared<acquisition::Listener>(
        line.device(), acquisition::framing_of(line.name()), calibration, inbox_);
    line.add(made);
    return made;
  };
  // How long a ping takes on the line bears on the clocks.
  acquisition::mcap::Settings settings;
  settings.loadcell.baud = lines_->loadcell.baud();
  std::vector<Entry> first{acquisition::NewSettings{acquisition::host_now_s(), settings}};
  inbox_.push(first);
  module_ = listener(lines_->module, std::nullopt);
  loadcell_ = listener(lines_->loadcell, options.loadcell);
  thread_ = std::thread([this] { run(); });
}

LiveFeed::~LiveFeed() {
  lines_->module.remove(module_);
  lines_->loadcell.remove(loadcell_);
  inbox_.close();
  thread_.join();
}

void LiveFeed::run() {
  std::vector<Entry> entries;
  double follow_s = 0.0, clocks_s = 0.0;
  while (inbox_.take(entries, look_every_s)) {
    const double now_s = acquisition::host_now_s();
    LiveNews news;
    follower_.take(entries);
    if (now_s >= clocks_s) {
      follower_.hold_clocks();
      clocks_s = now_s + clocks_every_s;
    }
    if (now_s >= follow_s) {
      follower_.follow(news.more);
      follow_s = now_s + follow_every_s;
    }
    follower_.tail(news.tail_t_s, news.tail_nm);
    for (Entry& entry : entries) {
      if (auto* event = std::get_if<acquisition::Event>(&entry))
        news.events.push_back(std::move(*event));
      if (const auto* row = std::get_if<acquisition::SampleRow>(&entry)) {
        news.newest_host_s = row->host_s();
        if (row->device == StreamId::loadcell) news.counts.push_back(row->values[4]);
      }
    }
    const std::lock_guard lock(mutex_);
    news_.more.append(news.more);
    news_.more.forget_before(follower_.now_s() - unseen_s);
    news_.tail_t_s = std::move(news.tail_t_s);
    news_.tail_nm = std::move(news.tail_nm);
    for (auto& event : news.events) news_.events.push_back(std::move(event));
    if (news_.events.size() > most_events)
      news_.events.erase(news_.events.begin(), news_.events.end() - most_events / 2);
    news_.clock = follower_.clock();
    news_.now_s = follower_.now_s();
    if (news.newest_host_s > 0.0) news_.newest_host_s = news.newest_host_s;
    news_.counts.insert(news_.counts.end(), news.counts.begin(), news.counts.end());
    if (news_.counts.size() > most_counts) news_.counts.clear();
  }
}

double LiveNews::time_of(const acquisition::Event& event) const {
  const double heard_s = newest_host_s > 0.0 ? newest_host_s : acquisition::host_now_s();
  return now_s - (heard_s - event.host_s);
}

LiveNews LiveFeed::take() {
  LiveNews news;
  {
    const std::lock_guard lock(mutex_);
    news.clock = news_.clock;
    news.now_s = news_.now_s;
    news.newest_host_s = news_.newest_host_s;
    std::swap(news, news_);  // what holds on stays
  }
  news.module = module_->report();
  news.loadcell = loadcell_->report();
  return news;
}

}  // namespace searig::app
