// Firmware on the simulated board through libserialport, for a minute, as the issue asks for it.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <map>

#include "tests/acquisition/source/listener.h"
#include "tests/arduino/device_processes.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition {
namespace {

using Kind = Arrival::Kind;

/// A force that is a straight line of time makes each sample's counts tell when it was taken.
constexpr double kCountsPerSecond = 2000.0 * 0.5;

class Minute : public testing::Test {
 protected:
  std::string link() const { return (folder_.path() / "ttyLoadcell").string(); }

  static void print(const Listener& listener) {
    const WireCounters& c = listener.decoder.counters();
    std::printf(
        "samples %lu lost %lu (in gaps %lu) doubled %lu bad CRC %lu malformed %lu cut %lu "
        "implausible %lu restarts %lu overruns %lu\n",
        c.samples, c.lost, c.lost_in_gaps, c.doubled, c.parser.bad_crc, c.parser.malformed,
        c.parser.cut, c.implausible, c.restarts, c.device_overruns);
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(Minute, LosesNothingAndRecoversTheSkewWithinTwoPpm) {
  for (const double skew_ppm : {200.0, -2000.0}) {
    BoardProcess board(link(), {"--skew-ppm", std::to_string(skew_ppm)});
    Listener listener(open_source(link()));
    listener.for_seconds(60.0);
    const WireCounters& counters = listener.decoder.counters();
    const double found_ppm = listener.skew_ppm();
    print(listener);
    std::printf("skew %.0f ppm, found %.2f ppm\n", skew_ppm, found_ppm);
    EXPECT_NEAR(static_cast<double>(counters.samples), 3000.0, 60.0);
    EXPECT_EQ(counters.lost, 0u);
    EXPECT_EQ(listener.damaged(), 0u);
    EXPECT_EQ(counters.device_overruns, 0u);
    EXPECT_NEAR(found_ppm, skew_ppm, 2.0);
  }
}

/// How many samples show other counts than the force had at their time. The device's clock begins
/// anew at a reset while the force goes on, so each run has a line of its own: through its middle.
std::size_t wrong_samples(const Listener& listener) {
  std::map<std::uint32_t, std::vector<double>> offsets;  // s, by run
  for (const auto& sample : listener.all<LoadcellSample>()) {
    if (sample.settling || sample.repeated) continue;
    offsets[sample.at.run].push_back((sample.counts - 84000.0) / kCountsPerSecond -
                                     sample.at.device_s);
  }
  std::size_t wrong = 0;
  for (auto& [run, values] : offsets) {
    auto sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double middle = sorted[sorted.size() / 2];
    for (const double value : values) wrong += std::abs(value - middle) > 0.01;
  }
  return wrong;
}

TEST_F(Minute, TakesNoWrongSampleThroughUnplugResetLossAndWrongBits) {
  BoardProcess board(link(), {"--force", "ramp:0.5"});
  Listener listener(open_source(link()));
  listener.for_seconds(8.0);
  ASSERT_EQ(board.command("unplug"), "ok");
  listener.for_seconds(3.0);
  ASSERT_EQ(board.command("plug"), "ok");
  listener.for_seconds(8.0);
  ASSERT_EQ(board.command("reset"), "ok");
  listener.for_seconds(8.0);
  ASSERT_EQ(board.command("drop 0.01"), "ok");
  listener.for_seconds(14.0);
  ASSERT_EQ(board.command("drop 0"), "ok");
  ASSERT_EQ(board.command("flip 0.001"), "ok");
  listener.for_seconds(14.0);
  ASSERT_EQ(board.command("flip 0"), "ok");
  ASSERT_EQ(board.command("stall 0.06"), "ok");
  listener.for_seconds(4.0);
  print(listener);
  const WireCounters& counters = listener.decoder.counters();
  EXPECT_EQ(wrong_samples(listener), 0u);
  EXPECT_EQ(listener.kinds(), (std::vector{Kind::connected, Kind::unplugged, Kind::reconnected}));
  EXPECT_EQ(counters.restarts, 1u);
  EXPECT_NEAR(static_cast<double>(counters.lost_in_gaps), 150.0, 10.0);
  EXPECT_GT(counters.lost, counters.lost_in_gaps + 50);  // 1 % of 700, and 17 % of another 700
  EXPECT_GT(listener.damaged(), 50u);
}

double processor_s() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

TEST_F(Minute, HearsAThousandHertzAndFiftyWithoutALoss) {
  BoardProcess board(link());
  ModuleProcess process({"--rate", "1000"});
  Listener loadcell(open_source(link())), module(open_source(process.name));
  Source* const both[] = {loadcell.source.get(), module.source.get()};
  const double begin_s = host_now_s(), used_s = processor_s();
  while (host_now_s() < begin_s + 60.0) {
    wait_for(both, 0.1);
    loadcell.round(0.0);
    module.round(0.0);
  }
  std::printf("processor: %.2f %% of one core\n", 100.0 * (processor_s() - used_s) / 60.0);
  print(loadcell);
  print(module);
  EXPECT_EQ(loadcell.decoder.counters().lost + module.decoder.counters().lost, 0u);
  EXPECT_EQ(loadcell.damaged() + module.damaged(), 0u);
  EXPECT_NEAR(static_cast<double>(module.decoder.counters().samples), 60000.0, 1000.0);
}

}  // namespace
}  // namespace searig::acquisition
