// searig info, sync and export, as a user calls them: answers, error sentences, exit codes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/system/run_program.h"
#include "tests/temporary_folder.h"

namespace searig {
namespace {

namespace fs = std::filesystem;

const std::string toml =
    "format = \"searig-recording/1\"\n[module]\nfile = \"module.csv\"\ngear_ratio = 349.0\n"
    "[loadcell]\nfile = \"loadcell.csv\"\nlever_arm_m = 0.15\n";

/// Ten seconds with stamps of the host; the load cell's clock runs 100 ppm fast and began at 7 s.
struct Files {
  TemporaryFolder folder;
  std::string module = "t_s,host_s,input_angle_rad,output_angle_rad,current_a\n";
  std::string loadcell = "t_s,host_s,seq,force_n\n";

  Files() {
    for (int i = 0; i < 2500; ++i) {
      const double t = 0.004 * i;
      module += line({t, t + 50.0002 + 1e-5 * (i % 7), 0.2 * std::sin(3 * t), 0.0, 0.5});
      if (i % 5 == 0)
        loadcell += line({7 + t * (1 + 1e-4), t + 50.0002 + 1e-5 * (i % 3), i / 5.0, 50.0});
    }
    keep("recording.toml", toml);
    keep("module.csv", module);
    keep("loadcell.csv", loadcell);
  }
  static std::string line(const std::vector<double>& values) {
    std::string out;
    for (const double v : values) out += std::to_string(v) + ',';
    out.back() = '\n';
    return out;
  }
  void keep(const std::string& name, const std::string& text) const { folder.write(name, text); }
  /// The same with the 100th line's last field replaced.
  static std::string spoiled(std::string text, const std::string& field) {
    std::size_t end = 0;
    for (int i = 0; i < 100; ++i) end = text.find('\n', end) + 1;
    const std::size_t from = text.rfind(',', end - 2) + 1;
    return text.replace(from, end - 1 - from, field);
  }
  std::string path() const { return folder.path().string(); }
};

std::size_t lines(const std::string& text) {
  return std::size_t(std::count(text.begin(), text.end(), '\n'));
}

TEST(InfoCommand, SaysWhatIsThereAndWhatIsMissing) {
  const Files files;
  const Ran ran = run_program("searig info " + files.path());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  for (const char* part :
       {"gear ratio 349", "250.0 Hz", "50.0 Hz", "input_angle_rad", "clocks: ", "no temperatures"})
    EXPECT_NE(ran.out.find(part), std::string::npos) << part << ran.out;
}

TEST(SyncCommand, MapsOneClockToTheOtherForPeopleAndForMachines) {
  const Files files;
  const Ran said = run_program("searig sync " + files.path());
  EXPECT_EQ(said.exit_code, 0) << said.err;
  EXPECT_NE(said.out.find("+100.0 ppm"), std::string::npos) << said.out;
  const Ran ran = run_program("searig sync " + files.path() + " --json -");
  const auto answer = nlohmann::json::parse(ran.out);  // nothing else on stdout
  EXPECT_EQ(answer.at("format"), "searig-sync/1");
  const auto& map = answer.at("loadcell_to_module");
  EXPECT_NEAR(map.at("rate"), 1 / (1 + 1e-4), 1e-5);
  const double rate = map.at("rate"), offset = map.at("offset_s");
  EXPECT_NEAR(rate * (7 + 5 * (1 + 1e-4)) + offset, 5.0, 1e-4);
  EXPECT_GT(map.at("ci95_s"), 0.0);
  EXPECT_TRUE(answer.at("trusted").is_boolean());
  EXPECT_FALSE(answer.at("why").get<std::string>().empty());
  ASSERT_EQ(answer.at("streams").size(), 2u);
  EXPECT_EQ(answer.at("streams").at(0).at("name"), "module");
  for (const char* count : {"received", "lost", "doubled", "garbled", "out_of_order", "rate_hz"})
    EXPECT_TRUE(answer.at("streams").at(1).at(count).is_number()) << count;
}

TEST(ExportCommand, WritesATableAndAnAnswer) {
  const Files files;
  const auto csv = files.folder.path() / "table.csv", json = files.folder.path() / "answer.json";
  const Ran ran = run_program("searig export " + files.path() + " --format csv --out " +
                              csv.string() + " --json " + json.string());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_GT(lines(text_of(csv)), 490u);
  const auto answer = nlohmann::json::parse(text_of(json));
  EXPECT_EQ(answer.at("format"), "searig-export/1");
  EXPECT_EQ(answer.at("file"), csv.string());
  EXPECT_EQ(answer.at("loadcell_samples"), 500);
  EXPECT_EQ(run_program("searig export " + files.path() + " --out -").out, text_of(csv));
}

TEST(BadRecordings, GetOneSentenceWithTheirPlaceFromEveryCommand) {
  const struct {
    std::string what;
    std::function<void(const Files&)> spoil;
    std::string place;
  } cases[] = {
      {"empty", [](auto& f) { f.keep("module.csv", ""); }, "module.csv, line 1, column 1: "},
      {"no column", [](auto& f) { f.keep("loadcell.csv", "t_s,weight\n0,1\n1,1\n"); },
       "loadcell.csv, line 1: column force_n (or torque_nm) is missing"},
      {"text", [](auto& f) { f.keep("module.csv", Files::spoiled(f.module, "fast")); },
       "module.csv, line 100, column current_a: 'fast' is not a number"},
      {"NaN", [](auto& f) { f.keep("loadcell.csv", Files::spoiled(f.loadcell, "nan")); },
       "loadcell.csv, line 100, column force_n: 'nan' is not a finite number"},
      {"one sample", [](auto& f) { f.keep("loadcell.csv", "t_s,force_n\n0,1\n"); },
       "loadcell.csv, line 2, column t_s: this is the only sample"},
      {"unsorted", [](auto& f) { f.keep("loadcell.csv", "t_s,force_n\n5,1\n4,1\n3,1\n2,1\n"); },
       "loadcell.csv, line 3, column t_s: the clock is not sorted"},
      {"no file", [](auto& f) { fs::remove(f.folder.path() / "module.csv"); },
       "module.csv: cannot be read: No such file or directory"},
      {"no toml", [](auto& f) { fs::remove(f.folder.path() / "recording.toml"); },
       "recording.toml: is missing"},
      {"syntax", [](auto& f) { f.keep("recording.toml", toml + "[modul\n"); },
       "recording.toml, line 8, column "},
      {"lever", [](auto& f) { f.keep("recording.toml", toml.substr(0, toml.find("lever"))); },
       "recording.toml: loadcell.lever_arm_m is missing"}};
  for (const auto& bad : cases) {
    const Files files;
    bad.spoil(files);
    for (const char* command : {"info ", "sync ", "evaluate ", "export --out - "}) {
      const Ran ran = run_program("searig " + std::string(command) + files.path());
      EXPECT_EQ(ran.exit_code, 1) << bad.what << " " << command;
      EXPECT_EQ(ran.out, "") << bad.what << " " << command;
      EXPECT_EQ(lines(ran.err), 1u) << ran.err;
      EXPECT_EQ(ran.err.find("searig: " + files.path() + "/" + bad.place), 0u) << ran.err;
    }
  }
}

TEST(BadRecordings, AreToldFromFoldersThatMayNotBeRead) {
  const Files files;
  fs::permissions(files.folder.path(), fs::perms::none);
  const std::string nobody = "setpriv --reuid=65534 --regid=65534 --clear-groups ";
  const std::string as = geteuid() == 0 ? nobody : "";
  if (run_program("searig --version", as).exit_code != 0) GTEST_SKIP() << "no other user runs it";
  const Ran ran = run_program("searig sync " + files.path(), as);
  fs::permissions(files.folder.path(), fs::perms::owner_all);
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(ran.err, "searig: " + files.path() + ": cannot be read: Permission denied.\n");
}

TEST(Estimates, OfWhatCannotBeEvaluatedNameTheRecording) {
  const Files files;
  files.keep("loadcell.csv", "t_s,force_n\n900,1\n901,2\n902,3\n903,4\n904,5\n905,5\n");
  const Ran ran = run_program("searig evaluate " + files.path());
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(ran.err.find("searig: " + files.path() + ": "), 0u) << ran.err;
  const Ran sync = run_program("searig sync " + files.path());
  EXPECT_NE(sync.out.find("NOT TRUSTED: without host"), std::string::npos) << sync.out;
}

TEST(WrongUse, ExitsWithTwoAndSaysWhere) {
  const Files files;
  for (const std::string& arguments :
       {std::string(""), std::string("tune"), std::string("info"), "info --loud " + files.path(),
        "info " + files.path() + " another", "export " + files.path(),
        "export --format xls --out x " + files.path(), std::string("demo --seconds soon")}) {
    const Ran ran = run_program("searig " + arguments);
    EXPECT_EQ(ran.exit_code, 2) << arguments;
    EXPECT_EQ(ran.out, "") << arguments;
    EXPECT_NE(ran.err, "") << arguments;
  }
  EXPECT_NE(run_program("searig tune").err.find("no command tune"), std::string::npos);
}

TEST(Help, HasAnExampleForEveryCommand) {
  for (const char* command : {"", "demo", "info", "sync", "evaluate", "diagnose", "export"}) {
    const Ran ran = run_program("searig " + std::string(command) + " --help");
    EXPECT_EQ(ran.exit_code, 0) << command;
    EXPECT_NE(ran.out.find("Example"), std::string::npos) << command;
  }
}

TEST(Answers, ThatCannotBeWrittenFail) {
  const Files files;
  const Ran json = run_program("searig sync " + files.path() + " --json /nowhere/a.json");
  EXPECT_EQ(json.exit_code, 1);
  EXPECT_EQ(json.err, "searig: /nowhere/a.json: cannot be written: No such file or directory.\n");
  EXPECT_EQ(run_program("searig export " + files.path() + " --out /nowhere/a.csv").exit_code, 1);
  const Ran demo = run_program("searig demo --seconds 5 --headless --out /dev/null/out");
  EXPECT_EQ(demo.exit_code, 1);
  EXPECT_EQ(demo.err.find("searig: /dev/null/out: cannot be made: "), 0u) << demo.err;
}

}  // namespace
}  // namespace searig
