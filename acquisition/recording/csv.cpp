#include "acquisition/recording/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/recording/text_file.h"

namespace searig::acquisition {
namespace {

constexpr std::size_t kNotAsked = static_cast<std::size_t>(-1);

std::string_view trimmed(std::string_view field) {
  while (!field.empty() && (field.front() == ' ' || field.front() == '\t')) field.remove_prefix(1);
  while (!field.empty() && (field.back() == ' ' || field.back() == '\t' || field.back() == '\r'))
    field.remove_suffix(1);
  return field;
}

/// The line that begins at `begin`, without its end; `next` is where the following one begins.
std::string_view line_at(std::string_view text, std::size_t begin, std::size_t& next) {
  const auto* end =
      static_cast<const char*>(std::memchr(text.data() + begin, '\n', text.size() - begin));
  const std::size_t stop = end ? static_cast<std::size_t>(end - text.data()) : text.size();
  next = std::min(stop + 1, text.size());
  std::string_view line = text.substr(begin, stop - begin);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

char separator_of(std::string_view header) {
  for (const char candidate : {',', ';', '\t'})
    if (header.find(candidate) != std::string_view::npos) return candidate;
  return ',';
}

std::vector<std::string> header_fields(std::string_view line, char separator) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == separator && !quoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  for (std::string& field : fields) field = std::string(trimmed(field));
  return fields;
}

/// What a field is: a finite number, or why not.
enum class Field { number, empty, text, not_finite };

Field parse(std::string_view field, double& value) {
  const char* begin = field.data();
  const char* end = begin + field.size();
  auto result = std::from_chars(begin, end, value);
  if (result.ptr != end || result.ec != std::errc{}) {  // the slow road: spaces and a plus sign
    field = trimmed(field);
    if (field.empty()) return Field::empty;
    if (field.front() == '+') field.remove_prefix(1);
    end = field.data() + field.size();
    result = std::from_chars(field.data(), end, value);
    if (result.ec == std::errc::result_out_of_range) return Field::not_finite;
    if (result.ptr != end || result.ec != std::errc{}) return Field::text;
  }
  return std::isfinite(value) ? Field::number : Field::not_finite;
}

std::string why(Field field, std::string_view text) {
  std::string shown(trimmed(text).substr(0, 40));
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  if (field == Field::empty) return "the number is missing";
  if (field == Field::not_finite) return "'" + shown + "' is not a finite number";
  return "'" + shown + "' is not a number";
}

/// What one line came to.
struct RowResult {
  std::size_t fields = 0;              // how many the line has
  std::size_t bad_column = kNotAsked;  // the first asked-for field that is no number
  Field bad = Field::number;
  std::string_view bad_text;
};

/// Splits the line once and parses what is asked for: slots[column] is where its value goes.
RowResult parse_row(std::string_view line, char separator, std::span<const std::size_t> slots,
                    std::span<double> values) {
  RowResult row;
  std::size_t begin = 0;
  while (true) {
    std::size_t end = line.find(separator, begin);
    if (end == std::string_view::npos) end = line.size();
    if (row.fields < slots.size() && slots[row.fields] != kNotAsked) {
      const std::string_view text = line.substr(begin, end - begin);
      const Field field = parse(text, values[slots[row.fields]]);
      if (field != Field::number && row.bad == Field::number)
        row = {row.fields, row.fields, field, text};
    }
    ++row.fields;
    if (end == line.size()) return row;
    begin = end + 1;
  }
}

}  // namespace

CsvFile::CsvFile(std::filesystem::path path, bool has_header)
    : path_(std::move(path)), text_(read_text_file(path_)) {
  if (std::string_view(text_).substr(0, 3) == "\xEF\xBB\xBF") body_ = 3;  // byte order mark
  if (text_.find_first_not_of(" \t\r\n", body_) == std::string::npos)
    throw InputError(path_.string() + ", line 1: the file is empty.");
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
                   std::string(column) + " is missing; the header names " + there + ".");
}

CsvRows CsvFile::read(std::span<const std::size_t> columns, Faults faults) const {
  const std::size_t last = *std::max_element(columns.begin(), columns.end());
  std::vector<std::size_t> slots(last + 1, kNotAsked);
  for (std::size_t slot = columns.size(); slot-- > 0;) slots[columns[slot]] = slot;
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
                            : place(number, row.bad_column) + why(row.bad, row.bad_text);
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
