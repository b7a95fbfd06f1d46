#include "acquisition/recording/csv.h"

#include <algorithm>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/recording/csv_row.h"
#include "acquisition/recording/mapped_file.h"
#include "acquisition/recording/text_file.h"

namespace searig::acquisition {

CsvFile::CsvFile(std::filesystem::path path, bool has_header) : path_(std::move(path)) {
  std::error_code not_there;
  if (std::filesystem::is_regular_file(path_, not_there)) {
    mapped_ = std::make_shared<MappedFile>(path_);
    text_ = mapped_->bytes();
  } else {
    copied_ = std::make_shared<std::string>(read_text_file(path_));
    text_ = *copied_;
  }
  if (text_.substr(0, 3) == "\xEF\xBB\xBF") body_ = 3;  // byte order mark
  if (text_.find_first_not_of(" \t\r\n", body_) == std::string::npos)
    throw InputError(path_.string() + ", line 1, column 1: the file is empty.");
  if (text_.substr(0, 1000).find('\0') != std::string_view::npos)
    throw InputError(path_.string() +
                     ", line 1, column 1: this is not text in UTF-8, but binary or UTF-16.");
  if (!has_header) {
    std::size_t next = 0;
    separator_ = separator_of(line_at(text_, body_, next));
    return;
  }
  std::size_t next = body_;
  std::string_view line;
  do {
    body_ = next;
    line = line_at(text_, body_, next);
    ++body_line_;
  } while (next < text_.size() && (trimmed(line).empty() || line.front() == '#'));
  body_ = next;
  separator_ = separator_of(line);
  header_ = header_fields(line, separator_);
}

std::size_t CsvFile::find(std::string_view column) const {
  return static_cast<std::size_t>(std::find(header_.begin(), header_.end(), column) -
                                  header_.begin());
}

std::string CsvFile::column_name(std::size_t column) const {
  return "column " + (column < header_.size() ? header_[column] : std::to_string(column));
}

void CsvFile::refuse_missing(std::string_view column) const {
  std::string there;
  for (const std::string& name : header_) there += (there.empty() ? "" : ", ") + name;
  throw InputError(path_.string() + ", line " + std::to_string(body_line_ - 1) + ": column " +
                   std::string(column) + " is missing; the header names " + quotable(there, 300) +
                   ".");
}

namespace {

constexpr std::size_t kPiece = 4096;  // rows

/// slots[column] is where its value goes.
std::vector<std::size_t> slots_of(std::span<const std::size_t> columns) {
  const std::size_t last = *std::max_element(columns.begin(), columns.end());
  std::vector<std::size_t> slots(last + 1, kNotAsked);
  for (std::size_t slot = columns.size(); slot-- > 0;) slots[columns[slot]] = slot;
  return slots;
}

}  // namespace

bool CsvFile::read_pieces(std::span<const std::size_t> columns,
                          const std::function<void(CsvRows& piece)>& take) const {
  const std::vector<std::size_t> slots = slots_of(columns);
  const std::size_t expected = std::max(header_.size(), slots.size());
  CsvRows piece;
  piece.columns.resize(columns.size());
  std::vector<double> values(columns.size());
  std::size_t begin = body_;
  while (begin < text_.size()) {
    const std::string_view line = line_at(text_, begin, begin);
    const RowResult row = parse_row(line, separator_, slots, values);
    if (row.fields != expected || row.bad != Field::number) {
      if (trimmed(line).empty()) continue;
      return false;
    }
    for (std::size_t slot = 0; slot < columns.size(); ++slot)
      piece.columns[slot].push_back(values[slots[columns[slot]]]);
    if (piece.columns.front().size() < kPiece) continue;
    take(piece);
    for (auto& column : piece.columns) column.clear();
    if (mapped_) mapped_->forget(begin);
  }
  take(piece);
  return true;
}

CsvRows CsvFile::read(std::span<const std::size_t> columns, Faults faults) const {
  const std::vector<std::size_t> slots = slots_of(columns);
  const std::size_t last = slots.size() - 1;
  const std::size_t expected = std::max(header_.size(), last + 1);

  CsvRows rows;
  rows.columns.resize(columns.size());
  std::vector<double> values(columns.size());
  std::string first_fault;
  std::size_t begin = body_;
  for (std::size_t number = body_line_; begin < text_.size(); ++number) {
    const std::string_view line = line_at(text_, begin, begin);
    if (trimmed(line).empty()) continue;
    const RowResult row = parse_row(line, separator_, slots, values);
    const bool misshapen =
        row.fields < expected || (row.fields > expected && faults == Faults::refuse);
    if (!misshapen && row.bad == Field::number) {
      for (std::size_t slot = 0; slot < columns.size(); ++slot)
        rows.columns[slot].push_back(values[slots[columns[slot]]]);
      rows.lines.push_back(number);
      continue;
    }
    ++rows.garbled;
    const bool refused = faults == Faults::refuse && !misshapen;
    if (!refused && !first_fault.empty()) continue;
    first_fault = misshapen ? place(number, std::min(row.fields, last)) + "the row has " +
                                  std::to_string(row.fields) + " fields where " +
                                  std::to_string(expected) + " belong"
                            : place(number, row.bad_column) + why_bad(row);
    if (refused) throw InputError(first_fault + ".");
  }
  refuse_unusable(rows, columns[0], faults, first_fault);
  return rows;
}

std::string CsvFile::place(std::size_t line, std::size_t column) const {
  return path_.string() + ", line " + std::to_string(line) + ", " + column_name(column) + ": ";
}

void CsvFile::refuse_unusable(const CsvRows& rows, std::size_t column, Faults faults,
                              const std::string& first_fault) const {
  const std::size_t good = rows.lines.size();
  const std::size_t all = good + rows.garbled;
  if (all == 0) throw InputError(place(body_line_, column) + "no row follows the header.");
  if (rows.garbled > (faults == Faults::refuse ? 1 + all / 20 : good))
    throw InputError(first_fault + ", and so it is in " + std::to_string(rows.garbled) + " of " +
                     std::to_string(all) + " rows.");
  if (good == 1)
    throw InputError(place(rows.lines[0], column) +
                     "this is the only sample; at least two are needed.");
}

}  // namespace searig::acquisition
