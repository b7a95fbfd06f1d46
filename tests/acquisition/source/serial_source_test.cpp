// The real libserialport, the real firmware on the simulated board, in real time.
#include "acquisition/source/serial_source.h"

#ifdef SEARIG_HAS_BOARD

#include <gtest/gtest.h>
#include <sys/file.h>
#include <termios.h>

#include "tests/acquisition/recording/refusal.h"
#include "tests/acquisition/source/listener.h"
#include "tests/arduino/device_processes.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition {
namespace {

using Kind = Arrival::Kind;

class SerialLine : public testing::Test {
 protected:
  std::string link() const { return (folder_.path() / "ttyLoadcell").string(); }

 private:
  TemporaryFolder folder_;
};

TEST_F(SerialLine, HearsTheBoardAndIsAnswered) {
  BoardProcess board(link());
  Listener listener(open_source("serial:" + link()));
  ASSERT_TRUE(listener.until([&] { return listener.all<LoadcellSample>().size() >= 50; }));
  listener.source->send(identify_frame());
  listener.source->send(ping_frame(5, host_now_s()));
  ASSERT_TRUE(listener.until(
      [&] { return !listener.all<Pong>().empty() && !listener.all<Identity>().empty(); }));
  const Pong pong = listener.all<Pong>().front();
  EXPECT_EQ(pong.id, 5u);
  EXPECT_GT(pong.at.host_s, pong.host_sent_s);
  EXPECT_GE(pong.at.device_s, pong.device_received_s);
  EXPECT_GT(listener.all<Identity>().front().newton_per_count, 0.0);
  EXPECT_EQ(listener.decoder.counters().lost, 0u);
  EXPECT_EQ(listener.damaged(), 0u);
  EXPECT_EQ(listener.kinds(), std::vector{Kind::connected});
}

TEST_F(SerialLine, NoticesTheUnplugWaitsQuietlyAndGoesOn) {
  BoardProcess board(link());
  Listener listener(open_source(link()));
  ASSERT_TRUE(listener.until([&] { return listener.decoder.counters().samples > 10; }));
  ASSERT_EQ(board.command("unplug"), "ok");
  ASSERT_TRUE(listener.until([&] { return listener.events.size() == 2; }));
  EXPECT_EQ(listener.source->handle(), -1);
  // A loop that spins comes round tens of thousands of times in this while.
  listener.rounds = 0;
  listener.for_seconds(0.5);
  EXPECT_LT(listener.rounds, 50u);
  const auto before = listener.decoder.counters().samples;
  ASSERT_EQ(board.command("plug"), "ok");
  ASSERT_TRUE(listener.until([&] { return listener.decoder.counters().samples > before + 10; }));
  EXPECT_EQ(listener.kinds(), (std::vector{Kind::connected, Kind::unplugged, Kind::reconnected}));
  const WireCounters& counters = listener.decoder.counters();
  EXPECT_EQ(counters.restarts, 0u);  // the board went on, unheard
  EXPECT_GT(counters.lost, 0u);
  EXPECT_EQ(counters.lost_in_gaps, counters.lost);
  EXPECT_EQ(listener.damaged(), 0u);
}

TEST_F(SerialLine, WaitsForADeviceThatIsNotThereYet) {
  Listener listener(open_source(link()));
  listener.for_seconds(0.3);
  EXPECT_EQ(listener.kinds(), std::vector{Kind::unusable});
  EXPECT_EQ(listener.events[0].what, link() + " is not there");
  BoardProcess board(link());
  ASSERT_TRUE(listener.until([&] { return listener.decoder.counters().samples > 5; }));
  EXPECT_EQ(listener.kinds(), (std::vector{Kind::unusable, Kind::connected}));
}

TEST_F(SerialLine, KeepsTheRestAroundABoardReset) {
  BoardProcess board(link());
  Listener listener(open_source(link()));
  ASSERT_TRUE(listener.until([&] { return listener.decoder.counters().samples > 20; }));
  ASSERT_EQ(board.command("reset"), "ok");
  ASSERT_TRUE(listener.until([&] { return listener.decoder.counters().restarts == 1; }));
  ASSERT_TRUE(listener.until([&] { return listener.all<LoadcellSample>().back().at.run == 1; }));
  EXPECT_EQ(listener.kinds(), std::vector{Kind::connected});
  EXPECT_LE(listener.damaged(), 1u);  // the frame that the reset cut short
}

TEST_F(SerialLine, IsHeldForOneProgramAndDoesNotResetTheBoardWhenClosed) {
  BoardProcess board(link());
  const auto source = open_source(link());
  EXPECT_EQ(refusal([&] { open_source(link()); }), link() + " is in use by another program");
  termios line{};
  ASSERT_EQ(tcgetattr(source->handle(), &line), 0);
  EXPECT_EQ(line.c_cflag & HUPCL, 0u);
}

TEST_F(SerialLine, RefusesWhatIsNoSerialPort) {
  const TemporaryFolder folder;
  const auto file = folder.write("notes.txt", "no port");
  EXPECT_EQ(refusal([&] { open_source(file.string()); }), file.string() + " is no serial port");
  EXPECT_EQ(refusal([] { open_source("serial:/dev/null"); }), "/dev/null is no serial port");
  EXPECT_NE(refusal([] { open_source("tty7"); }).find("is no source"), std::string::npos);
  EXPECT_NE(refusal([] { open_source("serial:/dev/ttyS0@fast"); }).find("NUMBER"),
            std::string::npos);
}

}  // namespace
}  // namespace searig::acquisition
#endif
