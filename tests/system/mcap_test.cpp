// Recordings in one file, as a user calls the commands; and what the official MCAP library reads.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "acquisition/recording/recording.h"
#include "acquisition/recording/write_recording.h"
#include "app/rig/simulated_rig.h"
#include "tests/system/answer_wherever.h"
#include "tests/system/run_program.h"

namespace searig {
namespace {

namespace fs = std::filesystem;

/// Eight seconds of the simulated rig as a folder, and the same as one file.
class McapFile : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    home_ = new TemporaryFolder;
    app::SimulatedRig rig;
    rig.run_until(8.0);
    acquisition::write_recording(rig.recording(), folder());
    std::ofstream(folder() + "/model.toml")
        << "format = \"searig-model/1\"\n[drive.motor]\ntorque_constant_nm_per_a = 2.6\n"
           "efficiency = 0.75\n";
    imported_ = run_program("searig import " + folder() + " --out " + file());
  }
  static void TearDownTestSuite() { delete home_; }

  static std::string folder() { return (home_->path() / "recording").string(); }
  static std::string file() { return (home_->path() / "recording.mcap").string(); }
  static fs::path at(const char* name) { return home_->path() / name; }

  static inline TemporaryFolder* home_ = nullptr;
  static inline Ran imported_;
};

TEST_F(McapFile, EveryCommandAnswersAsForTheFolder) {
  ASSERT_EQ(imported_.exit_code, 0) << imported_.err;
  for (const char* command : {"sync", "evaluate", "info"})
    EXPECT_EQ(answer_wherever(command, folder()), answer_wherever(command, file())) << command;
  const Ran a = run_program("searig export " + folder() + " --out " + at("a.csv").string());
  const Ran b = run_program("searig export " + file() + " --out " + at("b.csv").string());
  EXPECT_EQ(b.exit_code, 0) << b.err;
  EXPECT_EQ(text_of(at("a.csv")), text_of(at("b.csv")));
}

TEST_F(McapFile, IsNotWrittenOverNorImportedTwice) {
  const std::string before = text_of(file());
  const Ran again = run_program("searig import " + folder() + " --out " + file());
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_NE(again.err.find("is there already"), std::string::npos) << again.err;
  EXPECT_EQ(text_of(file()), before);
  const Ran twice = run_program("searig import " + file() + " --out " + at("c.mcap").string());
  EXPECT_EQ(twice.exit_code, 1);
  EXPECT_NE(twice.err.find("is one file already"), std::string::npos) << twice.err;
}

TEST_F(McapFile, CutOffItIsReadAndRecoveredAndBothSaySo) {
  const std::string bytes = text_of(file());
  const fs::path cut = home_->write("cut.mcap", bytes.substr(0, bytes.size() / 3));
  const Ran info = run_program("searig info " + cut.string());
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_NE(info.out.find("The file ends within a record; "), std::string::npos) << info.out;

  const fs::path whole = at("recovered.mcap");
  const Ran ran = run_program("searig recover " + cut.string() + " --out " + whole.string());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_NE(ran.out.find(" bytes behind what is whole are left out."), std::string::npos);
  const auto all = acquisition::read_recording(file());
  const auto part = acquisition::read_recording(whole);
  EXPECT_EQ(part.cut_off, "");
  ASSERT_GT(part.module.t_s.size(), 500u);
  ASSERT_LT(part.module.t_s.size(), all.module.t_s.size());
  EXPECT_TRUE(std::equal(part.module.t_s.begin(), part.module.t_s.end(), all.module.t_s.begin()));
  const auto &some = part.module.channel("current_a"), &every = all.module.channel("current_a");
  EXPECT_TRUE(std::equal(some.begin(), some.end(), every.begin()));
}

TEST_F(McapFile, RecoverSaysWhereThereIsNothingAndLeavesNoFile) {
  const fs::path text = home_->write("text.mcap", "no recording at all");
  const Ran ran = run_program("searig recover " + text.string() + " --out " + at("x").string());
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_NE(ran.err.find("is no MCAP file; there is nothing"), std::string::npos) << ran.err;
  EXPECT_FALSE(fs::exists(at("x")));
}

#ifdef SEARIG_NODE
/// What the official library and Foxglove's decoder read in a file, or nothing without them.
std::optional<nlohmann::json> officially(const fs::path& file, const fs::path& scratch) {
  const std::string reader = std::string(SEARIG_BINARY_DIR) + "/mcap_reader/";
  if (!fs::exists(reader + "installed")) return std::nullopt;
  const std::string words =
      SEARIG_NODE " " + reader + "read.mjs " + file.string() + " >" + scratch.string();
  EXPECT_EQ(std::system(words.c_str()), 0);
  return nlohmann::json::parse(text_of(scratch));
}
constexpr const char* no_reader = "npm could not fetch @mcap/core; is there a network?";

TEST_F(McapFile, TheOfficialReaderReadsTheSameNumbers) {
  const auto answer = officially(file(), at("official.json"));
  if (!answer) GTEST_SKIP() << no_reader;
  const auto recording = acquisition::read_recording(folder());
  for (const auto* stream : {&recording.module, &recording.loadcell}) {
    const auto& rows = (*answer)["topics"]["/" + stream->name]["rows"];
    ASSERT_EQ(rows.size(), stream->t_s.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      ASSERT_EQ(rows[i][0], stream->t_s[i]);
      ASSERT_EQ(rows[i][1], stream->host_s[i]);
      for (std::size_t c = 0; c < stream->channels.size(); ++c)
        ASSERT_EQ(rows[i][2 + c], stream->channels[c].values[i]);
    }
  }
  const std::size_t messages = 1 + recording.module.t_s.size() + recording.loadcell.t_s.size();
  EXPECT_EQ((*answer)["statistics"], messages);
  EXPECT_EQ((*answer)["streamed"]["Message"], messages);
  EXPECT_EQ((*answer)["attachments"].size(), 4u);
}

TEST_F(McapFile, TheOfficialReaderReadsEveryTopicOfARecordedOne) {
  const fs::path recorded = at("recorded.mcap");
  const Ran ran = run_program("searig record --loadcell sim: --module sim: --seconds 3 --out " +
                              recorded.string());
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto answer = officially(recorded, at("recorded.json"));
  if (!answer) GTEST_SKIP() << no_reader;
  const auto recording = acquisition::read_recording(recorded);
  const auto& topics = (*answer)["topics"];
  EXPECT_EQ(topics["/module"]["rows"].size(), recording.module.t_s.size());
  for (std::size_t i = 0; i < recording.loadcell.t_s.size(); ++i)
    ASSERT_EQ(topics["/loadcell"]["rows"][i].back(), recording.loadcell.channel("force_n")[i]);
  EXPECT_EQ(topics["/events"]["rows"].size(), recording.events.size());
  EXPECT_EQ(topics["/events"]["rows"][0][2], "connected");
  EXPECT_GT(topics["/module/raw"]["rows"].size(), 1000u);
  EXPECT_EQ(topics["/module/raw"]["rows"][5][1].back(), 0);  // a frame ends in a zero
  for (const char* topic : {"/settings", "/clock", "/module/counters", "/loadcell/counters"})
    EXPECT_TRUE(topics.contains(topic)) << topic;
}
#endif

}  // namespace
}  // namespace searig
