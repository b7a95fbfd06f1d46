// What survives what: cuts at every byte and every single flipped bit of a file.
#include <gtest/gtest.h>

#include <optional>

#include "acquisition/error.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "acquisition/recording/mcap/recover.h"
#include "tests/acquisition/recording/mcap/small_file.h"

namespace searig::acquisition::mcap {
namespace {

std::optional<Recording> read_if_any(std::string_view bytes) {
  try {
    return recording_of(bytes, "file");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Every value that was read is the one that was written at its place.
void expect_exact(const Recording& read) {
  const auto& angles = read.module.channel("deflection_rad");
  ASSERT_EQ(angles.size(), read.module.t_s.size());
  for (std::size_t i = 0; i < angles.size(); ++i) ASSERT_EQ(angles[i], SmallFile::angle(i));
  for (std::size_t i = 0; i < angles.size(); ++i) ASSERT_EQ(read.module.t_s[i], 0.01 * double(i));
  const auto& forces = read.loadcell.channel("force_n");
  for (std::size_t i = 0; i < forces.size(); ++i) ASSERT_EQ(forces[i], SmallFile::force(i));
  ASSERT_EQ(read.gear_ratio, 349.0);
}

/// The rows that `chunks` whole chunks hold, no fewer and no more.
void expect_chunks(const SmallFile& file, const std::optional<Recording>& read,
                   std::size_t chunks) {
  if (chunks == 0) {
    EXPECT_FALSE(read);
    return;
  }
  ASSERT_TRUE(read);
  EXPECT_EQ(read->module.t_s.size(), file.module_rows[chunks - 1]);
  EXPECT_EQ(read->loadcell.t_s.size(), file.loadcell_rows[chunks - 1]);
  EXPECT_EQ(read->module.counts.lost, chunks - 1);
  expect_exact(*read);
}

TEST(Damage, AFileOfOnlyChunksIsReadToItsEnd) {
  const SmallFile file(4, 10, false);
  const Recording read = recording_of(file.bytes, "file");
  EXPECT_EQ(read.module.t_s.size(), 40u);
  EXPECT_EQ(read.events.size(), 1u);
  EXPECT_EQ(read.cut_off, "The file was not finished; everything up to its end is there.");
}

TEST(Damage, AFinishedFileIsWhole) {
  const SmallFile file;
  const Recording read = recording_of(file.bytes, "file");
  expect_chunks(file, read, 4);
  EXPECT_EQ(read.cut_off, "");
}

TEST(Damage, CutAtEveryByteTheWholeChunksBeforeAreThere) {
  const SmallFile file;
  for (std::size_t size = 0; size < file.bytes.size(); ++size) {
    const auto read = read_if_any(std::string_view(file.bytes).substr(0, size));
    std::size_t at_least = 0;
    for (const std::size_t end : file.chunk_ends) at_least += size >= end;
    const std::size_t rows = read ? read->module.t_s.size() : 0;
    // A chunk counts as soon as it is whole, although its index is not.
    ASSERT_TRUE(rows == 10 * at_least || rows == 10 * (at_least + 1)) << size;
    expect_chunks(file, read, rows / 10);
    EXPECT_FALSE(read && read->cut_off.empty()) << size;
  }
}

TEST(Damage, AnySingleFlippedBitLeavesTheExactPrefix) {
  const SmallFile file;
  std::string bytes = file.bytes;
  std::size_t unseen = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::size_t before = 0;  // chunks that end before the flipped byte
    for (const std::size_t end : file.chunk_ends) before += at >= end;
    if (at < file.first_chunk) before = file.chunk_ends.size();  // only the header is touched
    for (int bit = 0; bit < 8; ++bit) {
      bytes[at] = char(bytes[at] ^ (1 << bit));
      const auto read = read_if_any(bytes);
      const std::size_t rows = read ? read->module.t_s.size() : 0;
      ASSERT_EQ(rows % 10, 0u) << at;
      ASSERT_GE(rows, 10 * before) << "byte " << at << ", bit " << bit;
      expect_chunks(file, read, rows / 10);
      if (read && read->cut_off.empty()) ++unseen;
      bytes[at] = char(bytes[at] ^ (1 << bit));
    }
  }
  // A flip is always noticed, whether or not it touched what was measured.
  EXPECT_EQ(unseen, 0u);
}

std::string recovered_from(std::string_view bytes) {
  std::string out;
  recover(bytes, "searig test", [&](std::string_view piece) { out.append(piece); });
  return out;
}

TEST(Recover, MakesAWholeFileOfWhatLiesBeforeTheDamage) {
  const SmallFile file;
  for (std::size_t at = 0; at < file.bytes.size(); at += 7) {
    std::string bytes = file.bytes;
    bytes[at] = char(bytes[at] ^ 0x10);
    const auto damaged = read_if_any(bytes);
    const auto recovered = read_if_any(recovered_from(bytes));
    ASSERT_EQ(damaged.has_value(), recovered.has_value()) << at;
    if (!damaged) continue;
    EXPECT_EQ(recovered->cut_off, "") << at;
    expect_chunks(file, recovered, recovered->module.t_s.size() / 10);
    EXPECT_EQ(recovered->module.t_s, damaged->module.t_s);
    EXPECT_EQ(recovered->module.host_s, damaged->module.host_s);
    EXPECT_EQ(recovered->events, damaged->events);
  }
}

TEST(Recover, AWholeFileStaysAsItIs) {
  const SmallFile file;
  const std::string once = recovered_from(file.bytes);
  EXPECT_EQ(once.size(), recovered_from(once).size());
  const Recording before = recording_of(file.bytes, "a"), after = recording_of(once, "b");
  EXPECT_EQ(after.loadcell.channel("counts"), before.loadcell.channel("counts"));
}

TEST(Recover, SendsNothingWhereThereIsNothing) {
  EXPECT_EQ(recovered_from(""), "");
  EXPECT_EQ(recovered_from("some text that is no MCAP file"), "");
  EXPECT_EQ(recovered_from(SmallFile().bytes.substr(0, 100)), "");
}

}  // namespace
}  // namespace searig::acquisition::mcap
