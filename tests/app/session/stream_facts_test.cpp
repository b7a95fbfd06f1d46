#include "app/session/stream_facts.h"

#include <gtest/gtest.h>

namespace searig::app {
namespace {

/// 100 Hz for a second, a restart, and 100 Hz for half a second; four rows lost.
acquisition::Stream restarted() {
  acquisition::Stream stream;
  stream.name = "loadcell";
  for (int i = 0; i <= 100; ++i)
    if (i < 40 || i > 43) stream.t_s.push_back(5.0 + 0.01 * i);
  stream.restarts = {stream.t_s.size()};
  for (int i = 0; i <= 50; ++i) stream.t_s.push_back(0.01 * i);
  stream.counts.received = stream.t_s.size();
  stream.counts.lost = 4;
  return stream;
}

TEST(StreamFacts, RateIsTheDevicesOwnThroughLossesAndRestarts) {
  EXPECT_NEAR(seconds_of(restarted()), 1.5, 1e-12);
  EXPECT_NEAR(rate_hz(restarted()), 100.0, 1e-9);
}

TEST(StreamFacts, JsonHasTheContractsNames) {
  const nlohmann::json json = stream_json(restarted());
  EXPECT_EQ(json.at("name"), "loadcell");
  EXPECT_EQ(json.at("received"), 148);
  EXPECT_EQ(json.at("lost"), 4);
  for (const char* name : {"doubled", "garbled", "out_of_order"}) EXPECT_EQ(json.at(name), 0);
  EXPECT_NEAR(json.at("rate_hz").get<double>(), 100.0, 1e-9);
}

TEST(StreamFacts, MissingChannelsSayWhatTheySwitchOff) {
  acquisition::Recording recording;
  recording.module.channels = {{"deflection_rad", {0.0}},
                               {"output_angle_rad", {0.0}},
                               {"input_velocity_rad_s", {0.0}},
                               {"winding_temperature_c", {0.0}}};
  recording.loadcell.t_s = {0.0};
  const std::vector<std::string> sentences = switched_off(recording);
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_EQ(sentences[0], "no current_a: no torque from the motor current.");
}

TEST(StreamFacts, AModuleAloneSaysWhatItLacks) {
  acquisition::Recording recording;
  EXPECT_EQ(switched_off(recording).at(0), "no load cell: nothing to hold the module against.");
}

}  // namespace
}  // namespace searig::app
