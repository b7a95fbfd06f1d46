#include "acquisition/recording/csv.h"

#include <gtest/gtest.h>

#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition {
namespace {

const std::vector<std::size_t> kBoth{0, 1};

TEST(Csv, ReadsTheColumnsAskedForInTheOrderAskedFor) {
  TemporaryFolder folder;
  const CsvFile file(folder.write("a.csv", "t_s,host_s,force_n\n1,2,3\n4,5,6e-3\n"), true);
  const CsvRows rows = file.read(std::vector<std::size_t>{2, 0, 2}, Faults::refuse);
  EXPECT_EQ(rows.columns[0], (std::vector<double>{3.0, 6e-3}));
  EXPECT_EQ(rows.columns[1], (std::vector<double>{1.0, 4.0}));
  EXPECT_EQ(rows.columns[2], rows.columns[0]);
  EXPECT_EQ(rows.lines, (std::vector<std::size_t>{2, 3}));
}

TEST(Csv, ReadsWhatOtherProgramsWrite) {
  TemporaryFolder folder;
  const CsvFile file(folder.write("a.csv",
                                  "\xEF\xBB\xBF# made by a spreadsheet\r\n"
                                  "\"time; s\";\"x\"\r\n 0.5 ;+1\r\n\r\n1.5;-2.\r\n"),
                     true);
  EXPECT_EQ(file.header(), (std::vector<std::string>{"time; s", "x"}));
  const CsvRows rows = file.read(kBoth, Faults::refuse);
  EXPECT_EQ(rows.columns[0], (std::vector<double>{0.5, 1.5}));
  EXPECT_EQ(rows.columns[1], (std::vector<double>{1.0, -2.0}));
  EXPECT_EQ(rows.lines, (std::vector<std::size_t>{3, 5}));
}

TEST(Csv, ReadsAFileWithoutAHeader) {
  TemporaryFolder folder;
  const CsvFile file(folder.write("a.csv", "0.1,7\n0.2,8"), false);
  EXPECT_EQ(file.read(kBoth, Faults::count).columns[1], (std::vector<double>{7.0, 8.0}));
}

TEST(Csv, ReadsEveryDigit) {
  TemporaryFolder folder;
  const CsvFile file(
      folder.write("a.csv", "a,b\n0.1,1530821160104310\n5e-324,-1.7976931348623157e308\n"), true);
  const CsvRows rows = file.read(kBoth, Faults::refuse);
  EXPECT_EQ(rows.columns[0], (std::vector<double>{0.1, 5e-324}));
  EXPECT_EQ(rows.columns[1], (std::vector<double>{1530821160104310.0, -1.7976931348623157e308}));
}

TEST(Csv, TellsTextInANumberByFileLineAndColumn) {
  TemporaryFolder folder;
  const auto path = folder.write("cell.csv", "t_s,force_n\n1,2\n2,abc\n3,4\n");
  const std::string why = refusal([&] { CsvFile(path, true).read(kBoth, Faults::refuse); });
  EXPECT_EQ(why, path.string() + ", line 3, column force_n: 'abc' is not a number.");
}

TEST(Csv, TellsNaNInfinityAndMissingNumbers) {
  TemporaryFolder folder;
  for (const char* bad : {"nan", "NaN", "inf", "-inf", "", " ", "1e999", "1.2.3", "0x10"}) {
    const auto path =
        folder.write("cell.csv", std::string("t_s,force_n\n1,2\n2,") + bad + "\n3,4\n");
    const std::string why = refusal([&] { CsvFile(path, true).read(kBoth, Faults::refuse); });
    EXPECT_TRUE(says(why, "cell.csv, line 3, column force_n: ")) << why;
  }
}

TEST(Csv, CountsTheSameFaultsInALogOfAWire) {
  TemporaryFolder folder;
  const auto path =
      folder.write("log.csv", "CAN BUS ok!\n1,2\nx,3\n2,\n3,nan\n-12.7\n4,5\n5,6\n6,7\n7,8\n");
  const CsvRows rows = CsvFile(path, false).read(kBoth, Faults::count);
  EXPECT_EQ(rows.garbled, 5u);
  EXPECT_EQ(rows.columns[0], (std::vector<double>{1, 4, 5, 6, 7}));
}

TEST(Csv, CountsATornLastLineAndGluedLinesInAnyFile) {
  TemporaryFolder folder;
  const auto path = folder.write("a.csv", "a,b\n1,2\n2,3\n3,4\n4,5\n5");
  EXPECT_EQ(CsvFile(path, true).read(kBoth, Faults::refuse).garbled, 1u);
  const auto glued = folder.write("b.csv", "a,b\n1,2\n2,33,4\n4,5\n");
  EXPECT_EQ(CsvFile(glued, true).read(kBoth, Faults::refuse).garbled, 1u);
}

TEST(Csv, RefusesAFileThatIsMostlyGarbled) {
  TemporaryFolder folder;
  const auto path = folder.write("a.csv", "a,b,c\n1,2\n2,3\n3,4\n");
  const std::string why = refusal([&] { CsvFile(path, true).read(kBoth, Faults::refuse); });
  EXPECT_TRUE(says(why, "a.csv, line 2, column b: the row has 2 fields where 3 belong")) << why;
  const auto text = folder.write("b.csv", "a,b\nx,y\nx,y\nx,y\n1,2\n");
  EXPECT_TRUE(
      says(refusal([&] { CsvFile(text, true).read(kBoth, Faults::count); }), "line 2, column a"));
}

TEST(Csv, RefusesFilesWithNothingToRead) {
  TemporaryFolder folder;
  EXPECT_TRUE(says(refusal([&] { CsvFile(folder.write("a.csv", ""), true); }),
                   "a.csv, line 1, column 1: the file is empty."));
  EXPECT_TRUE(says(refusal([&] { CsvFile(folder.write("a.csv", " \n\n"), true); }), "empty"));
  EXPECT_TRUE(says(refusal([&] { CsvFile(folder.path() / "none.csv", true); }), "none.csv"));
  EXPECT_TRUE(says(refusal([&] { CsvFile(folder.path(), true); }), "directory"));
  const std::string utf16(
      "t\0_\0s\0\n\0"
      "1\0\n\0",
      12);
  EXPECT_TRUE(says(refusal([&] { CsvFile(folder.write("u.csv", utf16), true); }),
                   "u.csv, line 1, column 1: this is not text"));
  const auto header = folder.write("h.csv", "t_s,force_n\n");
  EXPECT_TRUE(says(refusal([&] { CsvFile(header, true).read(kBoth, Faults::refuse); }),
                   "h.csv, line 2, column t_s: no row follows the header."));
  const auto one = folder.write("o.csv", "t_s,force_n\n1,2\n");
  EXPECT_TRUE(says(refusal([&] { CsvFile(one, true).read(kBoth, Faults::refuse); }),
                   "o.csv, line 2, column t_s: this is the only sample"));
}

}  // namespace
}  // namespace searig::acquisition
