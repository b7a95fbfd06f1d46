// Datagrams from a module that is a process of its own, and from others who have no business here.
#include "acquisition/source/udp_source.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/acquisition/recording/refusal.h"
#include "tests/acquisition/source/listener.h"
#include "tests/arduino/device_processes.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition {
namespace {

using Kind = Arrival::Kind;

TEST(UdpSource, HearsAModuleAtAThousandHertz) {
  ModuleProcess module({"--rate", "1000"});
  Listener listener(open_source(module.name));
  ASSERT_TRUE(listener.until([&] { return listener.all<ModuleSample>().size() >= 1000; }));
  listener.source->send(ping_frame(3, host_now_s()));
  ASSERT_TRUE(listener.until([&] { return !listener.all<Pong>().empty(); }));
  const Identity identity = listener.all<Identity>().front();
  EXPECT_EQ(identity.kind, Identity::Kind::module);
  EXPECT_EQ(identity.name, "simulated module");
  EXPECT_EQ(identity.gear_ratio, 349.0);
  EXPECT_EQ(identity.rate_hz, 1000.0);
  EXPECT_EQ(listener.decoder.counters().lost, 0u);
  EXPECT_EQ(listener.damaged(), 0u);
  double furthest = 0.0;
  for (const auto& sample : listener.all<ModuleSample>()) {
    furthest = std::max(furthest, std::abs(sample.input_angle_rad - sample.output_angle_rad));
  }
  EXPECT_GT(furthest, 0.0);
  EXPECT_EQ(listener.kinds(), std::vector{Kind::connected});
}

TEST(UdpSource, DropsAndCountsWhatDoesNotBelong) {
  ModuleProcess module;
  Listener listener(open_source(module.name));
  const auto& counters = listener.decoder.counters();
  ASSERT_TRUE(listener.until([&] { return counters.samples > 300; }));
  ASSERT_EQ(module.command("foreign 20"), "ok");
  ASSERT_EQ(module.command("long 5"), "ok");
  ASSERT_EQ(module.command("garbage 7"), "ok");
  ASSERT_EQ(module.command("replay 50"), "ok");
  ASSERT_TRUE(listener.until([&] { return counters.samples > 600; }));
  EXPECT_EQ(listener.source->counters().foreign, 20u);
  EXPECT_EQ(listener.source->counters().too_long, 5u);
  EXPECT_EQ(listener.damaged(), 7u);
  EXPECT_EQ(counters.doubled, 50u);
  EXPECT_EQ(counters.lost, 0u);
  EXPECT_EQ(counters.implausible + counters.restarts, 0u);
}

TEST(UdpSource, GoesOnBehindARestartAndASilence) {
  ModuleProcess module;
  Listener listener(open_source(module.name));
  const auto& counters = listener.decoder.counters();
  ASSERT_TRUE(listener.until([&] { return counters.samples > 100; }));
  ASSERT_EQ(module.command("reset"), "ok");
  ASSERT_TRUE(listener.until([&] { return counters.restarts == 1; }));
  ASSERT_EQ(module.command("unplug"), "ok");
  ASSERT_TRUE(listener.until([&] { return listener.events.size() == 2; }));
  const auto before = counters.samples;
  ASSERT_EQ(module.command("plug"), "ok");
  ASSERT_TRUE(listener.until([&] { return counters.samples > before + 50; }));
  EXPECT_EQ(listener.kinds(), (std::vector{Kind::connected, Kind::unplugged, Kind::reconnected}));
  EXPECT_EQ(counters.lost, counters.lost_in_gaps);
  EXPECT_EQ(counters.restarts, 1u);
}

TEST(UdpSource, IsBoundToLoopbackForAModuleOnLoopback) {
  UdpSource source("127.0.0.1", 5005);
  sockaddr_in mine{};
  socklen_t size = sizeof mine;
  ASSERT_EQ(getsockname(source.handle(), reinterpret_cast<sockaddr*>(&mine), &size), 0);
  EXPECT_EQ(ntohl(mine.sin_addr.s_addr), INADDR_LOOPBACK);
}

TEST(UdpSource, RefusesNamesThatMakeNoSense) {
  EXPECT_EQ(refusal([] { open_source("udp:127.0.0.1:0"); }),
            "'udp:127.0.0.1:0': a port is a number from 1 to 65535");
  EXPECT_EQ(refusal([] { open_source("udp:127.0.0.1"); }),
            "'udp:127.0.0.1' does not end in :NUMBER");
  EXPECT_EQ(refusal([] { open_source("udp:"); }), "'udp:' does not end in :NUMBER");
  EXPECT_TRUE(says(refusal([] { open_source("udp:no.such.host.invalid:5"); }), "has no address"));
}

/// The same frames over a serial line.
TEST(SerialSource, HearsAModule) {
  const TemporaryFolder folder;
  const std::string link = (folder.path() / "ttyModule").string();
  ModuleProcess module({"--serial", link});
  Listener listener(open_source("serial://" + link + "@1000000"));
  const auto& counters = listener.decoder.counters();
  ASSERT_TRUE(listener.until([&] { return counters.samples > 500; }));
  EXPECT_EQ(counters.lost, 0u);
  EXPECT_EQ(listener.damaged(), 0u);
}

}  // namespace
}  // namespace searig::acquisition
