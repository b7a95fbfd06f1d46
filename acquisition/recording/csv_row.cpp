#include "acquisition/recording/csv_row.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>

namespace searig::acquisition {

std::string_view trimmed(std::string_view field) {
  while (!field.empty() && (field.front() == ' ' || field.front() == '\t')) field.remove_prefix(1);
  while (!field.empty() && (field.back() == ' ' || field.back() == '\t' || field.back() == '\r'))
    field.remove_suffix(1);
  return field;
}

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

namespace {

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

}  // namespace

std::string quotable(std::string_view text, std::size_t longest) {
  std::string shown(text.substr(0, longest));
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return text.size() > longest ? shown + "..." : shown;
}

std::string why_bad(const RowResult& row) {
  const std::string shown = quotable(trimmed(row.bad_text), 40);
  if (row.bad == Field::empty) return "the number is missing";
  if (row.bad == Field::not_finite) return "'" + shown + "' is not a finite number";
  return "'" + shown + "' is not a number";
}

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

}  // namespace searig::acquisition
