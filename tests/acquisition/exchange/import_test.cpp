#include "acquisition/exchange/import.h"

#include <gtest/gtest.h>

#include <bit>
#include <functional>

#include "acquisition/exchange/csv.h"
#include "acquisition/exchange/hdf5.h"
#include "acquisition/exchange/mat.h"
#include "acquisition/recording/mcap/import.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "tests/acquisition/exchange/a_recording.h"
#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition::exchange {
namespace {

namespace fs = std::filesystem;

struct Format {
  const char* name;
  std::function<void(const Contents&, const fs::path&)> write;
};

void write_long(const Contents& contents, const fs::path& path) {
  std::ofstream file(path, std::ios::binary);
  write_csv_long(contents, [&](std::string_view piece) { file << piece; });
}

const std::vector<Format> formats{
    {"x.csv", write_long},
    {"x.mat", [](auto& contents, auto& path) { write_mat(contents, "searig test", path); }},
    {"x.h5", [](auto& contents, auto& path) { write_hdf5(contents, "searig test", path); }},
};

std::string bytes_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> out;
  for (const double value : values) out.push_back(std::bit_cast<std::uint64_t>(value));
  return out;
}

void expect_same(const Stream& a, const Stream& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(bits(a.t_s), bits(b.t_s)) << a.name;
  EXPECT_EQ(bits(a.host_s), bits(b.host_s)) << a.name;
  EXPECT_EQ(a.restarts, b.restarts);
  EXPECT_EQ(a.counts.lost, b.counts.lost);
  EXPECT_EQ(a.host_latency.has_value(), b.host_latency.has_value());
  ASSERT_EQ(a.channels.size(), b.channels.size());
  for (std::size_t i = 0; i < a.channels.size(); ++i) {
    EXPECT_EQ(a.channels[i].name, b.channels[i].name);
    EXPECT_EQ(bits(a.channels[i].values), bits(b.channels[i].values)) << a.channels[i].name;
  }
  ASSERT_EQ(a.pings.size(), b.pings.size());
  for (std::size_t i = 0; i < a.pings.size(); ++i) {
    EXPECT_EQ(a.pings[i].device_sent_s, b.pings[i].device_sent_s);
    EXPECT_EQ(a.pings[i].run, b.pings[i].run);
  }
}

void expect_same(const Recording& a, const Recording& b) {
  expect_same(a.module, b.module);
  expect_same(a.loadcell, b.loadcell);
  ASSERT_EQ(a.devices.size(), b.devices.size());
  for (std::size_t i = 0; i < a.devices.size(); ++i) {
    expect_same(a.devices[i].stream, b.devices[i].stream);
    EXPECT_EQ(a.devices[i].aligned_by, b.devices[i].aligned_by);
  }
  EXPECT_EQ(a.gear_ratio, b.gear_ratio);
  EXPECT_EQ(a.lever_arm_m, b.lever_arm_m);
  EXPECT_EQ(a.one_clock, b.one_clock);
  EXPECT_EQ(a.model_toml, b.model_toml);
  EXPECT_EQ(a.calibration, b.calibration);
  EXPECT_EQ(a.recorded, b.recorded);
  EXPECT_EQ(a.events, b.events);
}

/// As searig import writes it and reads it again.
Recording through_mcap(const Recording& recording) {
  std::string bytes;
  mcap::write_mcap(recording, {}, "searig test", [&](std::string_view piece) { bytes += piece; });
  Recording read = mcap::recording_of(bytes, "file");
  read.name = recording.name;
  return read;
}

TEST(ExportImport, GivesTheSameRecordingAndTheSameBytesAgain) {
  const TemporaryFolder folder;
  const Recording recording = a_recording();
  for (const Format& format : formats) {
    SCOPED_TRACE(format.name);
    const fs::path once = folder.path() / format.name, twice = folder.path() / "again";
    format.write(contents_of(recording), once);
    const Recording read = read_any(once);
    expect_same(recording, read);
    EXPECT_EQ(read.path, once);
    format.write(contents_of(through_mcap(read)), twice);
    EXPECT_TRUE(bytes_of(once) == bytes_of(twice));
  }
}

TEST(ExportImport, KeepsAModulesOwnLogAndOneClock) {
  const TemporaryFolder folder;
  Recording alone = a_recording();
  alone.loadcell = {};
  alone.loadcell.name = "loadcell";
  Recording one_clock = a_recording();
  one_clock.one_clock = true;
  one_clock.devices.clear();
  one_clock.module.host_s.clear();
  for (const Format& format : formats) {
    SCOPED_TRACE(format.name);
    format.write(contents_of(alone), folder.path() / format.name);
    expect_same(alone, read_any(folder.path() / format.name));
    fs::remove(folder.path() / format.name);
    format.write(contents_of(one_clock), folder.path() / format.name);
    expect_same(one_clock, read_any(folder.path() / format.name));
  }
}

TEST(ExportImport, RefusesAFileThatIsNotWholeInOneSentence) {
  const TemporaryFolder folder;
  const Contents contents = contents_of(a_recording(3.0));
  for (const Format& format : formats) {
    format.write(contents, folder.path() / format.name);
    const std::string bytes = bytes_of(folder.path() / format.name);
    for (const double share : {0.1, 0.5, 0.9, 0.999}) {
      const fs::path cut = folder.write(std::string("cut-") + format.name,
                                        bytes.substr(0, std::size_t(double(bytes.size()) * share)));
      const std::string why = refusal([&] { read_any(cut); });
      EXPECT_TRUE(says(why, cut.string())) << why;
      EXPECT_EQ(std::count(why.begin(), why.end(), '\n'), 0) << why;
    }
  }
}

TEST(ExportImport, SaysTheLineOfAChangedCsv) {
  const TemporaryFolder folder;
  write_long(contents_of(a_recording(3.0)), folder.path() / "x.csv");
  const std::string bytes = bytes_of(folder.path() / "x.csv");
  const auto why = [&](const std::string& from, const std::string& to) {
    std::string text = bytes;
    text.replace(text.find(from), from.size(), to);
    return refusal([&] { read_any(folder.write("changed.csv", text)); });
  };
  EXPECT_TRUE(says(why("\nt_s,", "\nt,"), "changed.csv: line ")) << why("\nt_s,", "\nt,");
  EXPECT_TRUE(
      says(why(",module,current_a,", ",module,courant_a,"), "belongs a row of module,current_a"));
  EXPECT_TRUE(says(why(",module,host_s,", ",module,host_s,x"), "is not a number"));
  EXPECT_TRUE(says(why("searig-export/1", "searig-export/9"), "which is not known here"));
  EXPECT_TRUE(
      says(refusal([&] { read_any(folder.write("more.csv", bytes + "1,1,module,seq,1\n")); }),
           "more rows than"));
  EXPECT_TRUE(says(refusal([&] {
                     std::ofstream table(folder.path() / "table.csv");
                     const Recording recording = a_recording(3.0);
                     write_csv_table(contents_of(recording), [&](auto piece) { table << piece; });
                     table.close();
                     read_any(folder.path() / "table.csv");
                   }),
                   "the long form"));
}

}  // namespace
}  // namespace searig::acquisition::exchange
