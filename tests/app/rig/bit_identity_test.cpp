// Live, replayed and batch estimates from the same raw frames are the same to the last bit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "acquisition/recorder/device_stream.h"
#include "acquisition/recorder/replay.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "acquisition/wire/line_faults.h"
#include "app/rig/believed_model.h"
#include "app/rig/live_estimate.h"
#include "app/rig/live_signals.h"
#include "app/session/session.h"
#include "arduino/module/simulated_module.h"

namespace searig::app {
namespace {

using acquisition::Arrival;
using acquisition::DeviceStream;
using acquisition::Entry;
using acquisition::Framing;
using acquisition::StreamId;

/// Follows the stiffness along the module's samples as they are decoded.
class Follower {
 public:
  void take(const std::vector<Entry>& entries) { signals_.take(entries); }
  void follow(bool ended = false) { estimate_.follow(signals_.signals(), ended); }
  const History& history() const { return estimate_.history(); }

 private:
  LiveSignals signals_{0.15};
  const estimator::Model model_ = believed_model(estimator::twin::Parameters{});
  LiveEstimate estimate_{model_, start_from(model_, 1.0)};
};

/// Fifteen seconds of a module that loses frames, followed while they come and recorded.
struct Live {
  std::string file;
  Follower follower;

  /// device_s: what the module's clock shows at the start. Near zero, differences of its times are
  /// rounded otherwise than later.
  Live(double look_every_s, double device_s) {
    module::SimulatedModule module({.clock_s = device_s});
    acquisition::LineFaults line(3);
    line.shares.drop = 0.01;
    acquisition::mcap::RecordingWriter out([&](std::string_view bytes) { file.append(bytes); },
                                           "searig test", 1.7e9);
    out.settings({}, started_s);
    DeviceStream modules(StreamId::module, Framing::datagrams);
    write_loadcell(out);
    for (double until_s = look_every_s; until_s < 15.0; until_s += look_every_s) {
      std::vector<Entry> entries;
      while (module.next_sample_s() < until_s) {
        const double host_s = started_s + module.next_sample_s() + 0.0003;
        const auto frame = line.pass(module.take_sample());
        if (!frame.empty()) modules.take({Arrival::Kind::bytes, host_s, frame, {}}, entries);
      }
      for (const Entry& entry : entries) acquisition::write_entry(entry, out);
      out.file().end_chunk();
      follower.take(entries);
      follower.follow();
    }
    out.file().finish();
    follower.follow(true);
  }

 private:
  static constexpr double started_s = 500.0;

  /// At rest: a session wants one, and the estimate does not look at it.
  static void write_loadcell(acquisition::mcap::RecordingWriter& out) {
    out.set_columns(StreamId::loadcell, {"t_s", "host_s", "run", "force_n"});
    for (double t = 0.0; t < 15.0; t += 0.02)
      out.sample(StreamId::loadcell, started_s + t,
                 std::vector{t, started_s + t + 0.001, 0.0, std::sin(t)});
  }
};

Follower replayed(const std::string& file, std::size_t follow_every) {
  Follower follower;
  DeviceStream modules(StreamId::module, Framing::datagrams);
  std::size_t arrivals = 0;
  acquisition::replay(file, [&](StreamId device, const Arrival& arrival) {
    if (device != StreamId::module) return;
    std::vector<Entry> entries;
    modules.take(arrival, entries);
    follower.take(entries);
    if (++arrivals % follow_every == 0) follower.follow();
  });
  follower.follow(true);
  return follower;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

class BitIdentity : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(DeviceClocks, BitIdentity, ::testing::Values(0.0, 437.5, 4290.0));

TEST_P(BitIdentity, LiveReplayedAndBatchAreTheSame) {
  const Live live(0.02, GetParam());
  const History& during = live.follower.history();
  ASSERT_GT(during.t_s.size(), 7000u);

  for (const std::size_t every : {1u, 37u, 1000u}) {
    const Follower again = replayed(live.file, every);
    EXPECT_TRUE(same_bits(again.history().t_s, during.t_s));
    EXPECT_TRUE(same_bits(again.history().stiffness_nm_per_rad, during.stiffness_nm_per_rad));
    EXPECT_TRUE(same_bits(again.history().estimated_nm, during.estimated_nm));
    EXPECT_TRUE(same_bits(again.history().current_nm, during.current_nm));
    EXPECT_TRUE(same_bits(again.history().weight, during.weight));
  }

  const Session session = session_of(acquisition::mcap::recording_of(live.file, "live"));
  const estimator::Model model = believed_model(estimator::twin::Parameters{});
  const auto evaluation = evaluate_session(session, model);
  ASSERT_TRUE(evaluation.online);
  const History batch = history_of(session.signals, evaluation);
  EXPECT_TRUE(same_bits(batch.t_s, during.t_s));
  EXPECT_TRUE(same_bits(batch.stiffness_nm_per_rad, during.stiffness_nm_per_rad));
  EXPECT_TRUE(same_bits(batch.estimated_nm, during.estimated_nm));
  EXPECT_TRUE(same_bits(batch.current_nm, during.current_nm));
  EXPECT_TRUE(same_bits(batch.weight, during.weight));
}

TEST_P(BitIdentity, TheRecordedSamplesAreThoseOfTheRawBytes) {
  const Live live(0.05, GetParam());
  const auto recorded = acquisition::mcap::recording_of(live.file, "live");
  std::vector<double> t_s, current_a;
  DeviceStream modules(StreamId::module, Framing::datagrams);
  acquisition::replay(live.file, [&](StreamId device, const Arrival& arrival) {
    std::vector<Entry> entries;
    if (device == StreamId::module) modules.take(arrival, entries);
    for (const Entry& entry : entries)
      if (const auto* row = std::get_if<acquisition::SampleRow>(&entry))
        t_s.push_back(row->t_s()), current_a.push_back(row->values[6]);
  });
  EXPECT_TRUE(same_bits(t_s, recorded.module.t_s));
  EXPECT_TRUE(same_bits(current_a, recorded.module.channel("current_a")));
}

}  // namespace
}  // namespace searig::app
