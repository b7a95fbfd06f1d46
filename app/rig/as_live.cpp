#include "app/rig/as_live.h"

#include <optional>

#include "acquisition/calibration/loadcell_calibration.h"
#include "acquisition/error.h"
#include "acquisition/recorder/replay.h"
#include "acquisition/recording/mapped_file.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "acquisition/source/decode.h"

namespace searig::app {
namespace {

using acquisition::Arrival;
using acquisition::DeviceStream;
using acquisition::Entry;
using acquisition::Listener;
using acquisition::StreamId;

FollowOptions options_of(const acquisition::mcap::Settings& settings) {
  FollowOptions options;
  options.lever_arm_m = settings.lever_arm_m;
  if (!settings.calibration.empty()) {
    const auto calibration =
        acquisition::parse_calibration(settings.calibration, "the recording's calibration");
    options.loadcell = {calibration.tare_counts, calibration.newton_per_count};
  }
  if (!settings.model_toml.empty())
    options.model = estimator::parse_model(settings.model_toml, "the recording's model");
  return options;
}

/// The two devices and who follows them, in the recording's own time.
class Again {
 public:
  explicit Again(const acquisition::mcap::Settings& settings)
      : follower_(options_of(settings)),
        module_(StreamId::module, acquisition::framing_of(settings.module.source)),
        loadcell_(StreamId::loadcell, acquisition::framing_of(settings.loadcell.source),
                  options_of(settings).loadcell) {
    entries_.push_back(acquisition::NewSettings{0.0, settings});
  }

  void take(StreamId device, const Arrival& arrival, double until_s) {
    if (!start_s_) start_s_ = clocks_s_ = follow_s_ = arrival.host_s;
    if (arrival.host_s > *start_s_ + until_s) return;
    Listener::Report& report = device == StreamId::module ? news_.module : news_.loadcell;
    report.connected = arrival.kind != Arrival::Kind::unplugged;
    news_.newest_host_s = arrival.host_s;
    stream(device).take(arrival, entries_);
    if (arrival.host_s < follow_s_) return;
    follow(arrival.host_s);
    follow_s_ = arrival.host_s + 0.05;
  }

  LiveNews news() {
    follow(clocks_s_);
    follower_.tail(news_.tail_t_s, news_.tail_nm);
    news_.clock = follower_.clock();
    news_.now_s = follower_.now_s();
    news_.module.counters = module_.counters();
    news_.loadcell.counters = loadcell_.counters();
    return std::move(news_);
  }

 private:
  DeviceStream& stream(StreamId device) { return device == StreamId::module ? module_ : loadcell_; }
  void follow(double host_s) {
    for (const Entry& entry : entries_)
      if (const auto* event = std::get_if<acquisition::Event>(&entry))
        news_.events.push_back(*event);
    follower_.take(entries_);
    entries_.clear();
    if (host_s >= clocks_s_) {
      follower_.hold_clocks();
      clocks_s_ = host_s + 1.0;
    }
    follower_.follow(news_.more);
  }

  LiveFollower follower_;
  DeviceStream module_, loadcell_;
  std::vector<Entry> entries_;
  LiveNews news_;
  std::optional<double> start_s_;
  double clocks_s_ = 0.0, follow_s_ = 0.0;
};

}  // namespace

LiveNews as_live(const std::filesystem::path& recording, double until_s) {
  const acquisition::MappedFile file(recording);
  Again again(acquisition::mcap::read_settings(recording));
  bool any = false;
  (void)acquisition::replay(file.bytes(), [&](StreamId device, const Arrival& arrival) {
    any = true;
    again.take(device, arrival, until_s);
  });
  if (!any)
    throw acquisition::InputError(recording.string() +
                                  ": holds no raw bytes, so it was not recorded here live.");
  return again.news();
}

}  // namespace searig::app
