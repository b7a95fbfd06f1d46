// Numbers out of a CSV file, in one pass and at the speed of std::from_chars.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace searig::acquisition {

/// What becomes of a row that cannot be used.
///
/// A row with fewer or more fields than the header (torn at the end of the file, two glued
/// together) is damage on the way: it is counted as garbled under either rule, as long as such rows
/// are few (refuse: 5 % and one; count: half). A row of the right shape that holds text, NaN or
/// infinity where a number belongs is another matter:
enum class Faults {
  refuse,  ///< it is told at once, by file, line and column: somebody wrote that file so
  count,   ///< it is one more garbled row: a log of a wire, faults and all
};

/// The columns asked for, row by row; lines[i] is where row i stands in the file, from 1.
struct CsvRows {
  std::vector<std::vector<double>> columns;
  std::vector<std::size_t> lines;
  std::size_t garbled = 0;
};

class MappedFile;

/// One CSV file. The separator is a comma, or what the header has instead (semicolon,
/// tab); lines that begin with # before the header are comments; quotes are understood in the
/// header only. Every error is an InputError that names file, line and column.
class CsvFile {
 public:
  /// Reads the file and, where it has one, its header.
  CsvFile(std::filesystem::path path, bool has_header);

  const std::filesystem::path& path() const { return path_; }
  const std::vector<std::string>& header() const { return header_; }

  /// Which column bears that name, from 0; header().size() where none does.
  std::size_t find(std::string_view column) const;

  /// Throws the sentence that a column is missing.
  [[noreturn]] void refuse_missing(std::string_view column) const;

  /// Reads the columns of these numbers. Only rows in which all of them are finite are kept.
  CsvRows read(std::span<const std::size_t> columns, Faults faults) const;

  /// The same without fault in it, a few thousand rows at a time, so that the file need not fit
  /// into memory. False, and nothing more, at the first row that cannot be used.
  bool read_pieces(std::span<const std::size_t> columns,
                   const std::function<void(CsvRows& piece)>& take) const;

  /// "column force_n", or "column 3" where the file has no header.
  std::string column_name(std::size_t column) const;

 private:
  std::string place(std::size_t line, std::size_t column) const;
  void refuse_unusable(const CsvRows& rows, std::size_t column, Faults faults,
                       const std::string& first_fault) const;

  std::filesystem::path path_;
  std::shared_ptr<const MappedFile> mapped_;   // the text is here
  std::shared_ptr<const std::string> copied_;  // or, of a pipe, here
  std::string_view text_;
  std::vector<std::string> header_;
  std::size_t body_ = 0;       // where the first row begins
  std::size_t body_line_ = 1;  // and on which line
  char separator_ = ',';
};

}  // namespace searig::acquisition
