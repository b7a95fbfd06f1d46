// The recorder and its threads on devices that are not there.
#include "acquisition/recorder/recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <thread>

#include "acquisition/recording/mcap/read_mcap.h"
#include "arduino/firmware/payloads.h"
#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition {
namespace {

/// Samples of a device as fast as they are asked for, each a millisecond after the last.
class FakeSource : public Source {
 public:
  explicit FakeSource(wire::Type type, int per_read = 5) : type_(type), per_read_(per_read) {}

  std::string name() const override { return "fake:"; }
  int handle() const override { return -1; }
  double wake_s() const override { return host_now_s() + 0.002; }
  void send(std::span<const std::uint8_t>) override {}
  const SourceCounters& counters() const override { return counters_; }
  void read(std::vector<Arrival>& arrivals) override {
    if (sequence_ == 0) arrivals.push_back({Arrival::Kind::connected, host_now_s(), {}, "Here."});
    for (int i = 0; i < per_read_; ++i) arrivals.push_back(next());
  }

 private:
  Arrival next() {
    std::uint8_t content[wire::kMaxPayload] = {};
    const auto size = std::size_t(wire::payload_size(type_));
    if (type_ == wire::Type::loadcell_sample) content[0] = std::uint8_t(1 + sequence_ % 100);
    Arrival arrival{
        Arrival::Kind::bytes, host_now_s(), std::vector<std::uint8_t>(wire::kMaxEncoded), {}};
    arrival.bytes.resize(
        wire::encode({wire::kProtocolVersion, type_, 1, sequence_, 1000 * sequence_}, content, size,
                     arrival.bytes.data()));
    ++sequence_;
    counters_.bytes += arrival.bytes.size();
    return arrival;
  }

  wire::Type type_;
  int per_read_;
  std::uint32_t sequence_ = 0;
  SourceCounters counters_;
};

RecorderOptions options_for(const std::filesystem::path& file, double seconds) {
  RecorderOptions options;
  options.file.path = file;
  options.file.program = "searig test";
  options.file.least_free_bytes = 0;
  options.seconds = seconds;
  options.lever_arm_m = 0.1;
  options.loadcell = CountsToForce{0.0, 0.5};
  return options;
}

TEST(Recorder, EverySampleThatCameIsInTheFile) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.mcap";
  auto options = options_for(file, 0.6);
  Recorder recorder(options, std::make_unique<FakeSource>(wire::Type::module_sample, 1),
                    std::make_unique<FakeSource>(wire::Type::loadcell_sample, 1));
  const std::atomic<bool> stop{false};
  int looks = 0;
  const RecorderState state = recorder.run(stop, [&](const RecorderState&) { ++looks; });
  const Recording read = read_recording(file);
  EXPECT_EQ(read.cut_off, "");
  EXPECT_EQ(read.module.t_s.size(), state.module.samples);
  EXPECT_EQ(read.loadcell.t_s.size(), state.loadcell.samples);
  EXPECT_GT(looks, 0);
  for (std::size_t i = 0; i < read.loadcell.t_s.size(); ++i)
    ASSERT_EQ(read.loadcell.channel("force_n")[i], 0.5 * double(1 + i % 100));
}

TEST(Recorder, WhatDoesNotFitTheQueueIsCountedAndSaid) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.mcap";
  auto options = options_for(file, 0.5);
  options.file.most_waiting = 200;  // far less than what comes between two chunks
  Recorder recorder(options, std::make_unique<FakeSource>(wire::Type::module_sample, 50),
                    std::make_unique<FakeSource>(wire::Type::loadcell_sample, 1));
  const std::atomic<bool> stop{false};
  const RecorderState state = recorder.run(stop);
  const Recording read = read_recording(file);
  EXPECT_LT(read.module.t_s.size(), state.module.samples);
  bool said = false;
  for (const Event& event : read.events) said = said || event.kind == "overflow";
  EXPECT_TRUE(said);
}

/// A serial line whose poll() waits for the kernel.
class SlowSource : public FakeSource {
 public:
  using FakeSource::FakeSource;
  void read(std::vector<Arrival>& arrivals) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    FakeSource::read(arrivals);
  }
};

TEST(Recorder, ADeviceThatKeepsItsThreadWaitingHoldsUpNoOther) {
  const TemporaryFolder folder;
  Recorder recorder(options_for(folder.path() / "a.mcap", 1.0),
                    std::make_unique<FakeSource>(wire::Type::module_sample, 1),
                    std::make_unique<SlowSource>(wire::Type::loadcell_sample, 1));
  const std::atomic<bool> stop{false};
  const RecorderState state = recorder.run(stop);
  EXPECT_GT(state.module.samples, 10 * state.loadcell.samples);
}

TEST(Recorder, StopsWhenItIsTold) {
  const TemporaryFolder folder;
  Recorder recorder(options_for(folder.path() / "a.mcap", 1e9),
                    std::make_unique<FakeSource>(wire::Type::module_sample, 1),
                    std::make_unique<FakeSource>(wire::Type::loadcell_sample, 1));
  std::atomic<bool> stop{false};
  (void)recorder.run(stop, [&](const RecorderState& now) { stop = now.module.samples > 50; });
  EXPECT_EQ(read_recording(folder.path() / "a.mcap").cut_off, "");
}

TEST(Recorder, ASilentDeviceIsNamedAndTheOtherKept) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.mcap";
  Recorder recorder(options_for(file, 0.3),
                    std::make_unique<FakeSource>(wire::Type::module_sample, 1),
                    std::make_unique<FakeSource>(wire::Type::loadcell_sample, 0));
  const std::atomic<bool> stop{false};
  try {
    (void)recorder.run(stop);
    ADD_FAILURE() << "nothing was said";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(says(error.what(), "no sample came from the load cell (fake:)")) << error.what();
  }
  EXPECT_TRUE(std::filesystem::exists(file));
}

/// Keeps what a listener hands on.
class Kept : public EntrySink {
 public:
  std::size_t push(std::vector<Entry>& batch) override {
    const std::lock_guard lock(mutex_);
    for (Entry& entry : batch)
      if (const auto* row = std::get_if<SampleRow>(&entry)) counts_ += row->device == device;
    batch.clear();
    return 0;
  }
  std::size_t samples() {
    const std::lock_guard lock(mutex_);
    return counts_;
  }
  StreamId device = StreamId::module;

 private:
  std::mutex mutex_;
  std::size_t counts_ = 0;
};

TEST(Recorder, BeginsAndEndsWhileTheLinesRunOn) {
  const TemporaryFolder folder;
  const auto lines =
      std::make_shared<Lines>(std::make_unique<FakeSource>(wire::Type::module_sample, 1),
                              std::make_unique<FakeSource>(wire::Type::loadcell_sample, 1));
  Kept view;
  const auto listener =
      std::make_shared<Listener>(StreamId::module, Framing::stream, std::nullopt, view);
  lines->module.add(listener);
  lines->start();
  const std::atomic<bool> stop{false};
  for (const char* name : {"a.mcap", "b.mcap"}) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    Recorder recorder(options_for(folder.path() / name, 0.3), lines);
    (void)recorder.run(stop);
  }
  const std::size_t seen = view.samples();
  lines->module.remove(listener);
  const std::size_t at_the_end = view.samples();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(view.samples(), at_the_end);
  lines->stop();

  const Recording a = read_recording(folder.path() / "a.mcap");
  const Recording b = read_recording(folder.path() / "b.mcap");
  EXPECT_EQ(a.cut_off + b.cut_off, "");
  EXPECT_GT(a.module.channel("seq").front(), 20.0);  // it began in the middle
  EXPECT_GT(b.module.channel("seq").front(), a.module.channel("seq").back());
  EXPECT_GT(seen, a.module.t_s.size() + b.module.t_s.size());
  for (const Recording* one : {&a, &b}) {
    const auto& seq = one->module.channel("seq");
    for (std::size_t i = 1; i < seq.size(); ++i) ASSERT_EQ(seq[i], seq[i - 1] + 1.0);
    bool connected = false;
    for (const Event& event : one->events) connected = connected || event.kind == "connected";
    EXPECT_TRUE(connected);
  }
}

/// A sink that notices whether it is given something after it has let go.
class Mortal : public EntrySink {
 public:
  std::size_t push(std::vector<Entry>& batch) override {
    pushed_after_end = pushed_after_end || ended;
    batch.clear();
    return 0;
  }
  std::atomic<bool> ended{false}, pushed_after_end{false};
};

TEST(Line, WhoHasLeftIsToldNothingMoreHoweverOftenItLeaves) {
  Line line(StreamId::module, std::make_unique<FakeSource>(wire::Type::module_sample, 1));
  Mortal sinks[3];
  std::vector<std::shared_ptr<Listener>> listeners;
  for (Mortal& sink : sinks) {
    listeners.push_back(
        std::make_shared<Listener>(StreamId::module, Framing::stream, std::nullopt, sink));
    line.add(listeners.back());
  }
  line.start();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  std::vector<std::thread> leaving;  // all at once
  for (int i = 0; i < 3; ++i)
    leaving.emplace_back([&, i] {
      line.remove(listeners[std::size_t(i)]);
      sinks[i].ended = true;
      line.remove(listeners[std::size_t(i)]);
    });
  for (auto& one : leaving) one.join();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  line.stop();
  for (const Mortal& sink : sinks) EXPECT_FALSE(sink.pushed_after_end);
}

TEST(Recorder, WhatAUserMarksIsInTheFile) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.mcap";
  auto options = options_for(file, 1e9);
  options.notes = "the stiff spring";
  Recorder recorder(options, std::make_unique<FakeSource>(wire::Type::module_sample, 1),
                    std::make_unique<FakeSource>(wire::Type::loadcell_sample, 1));
  std::atomic<bool> stop{false};
  (void)recorder.run(stop, [&](const RecorderState& now) {
    if (now.module.samples > 50) {
      recorder.mark("marker", "here");
      stop = true;
    }
  });
  const Recording read = read_recording(file);
  EXPECT_EQ(read.recorded, "the stiff spring");
  EXPECT_TRUE(std::any_of(read.events.begin(), read.events.end(), [](const Event& event) {
    return event.kind == "marker" && event.text == "here";
  }));
}

}  // namespace
}  // namespace searig::acquisition
