// One line of a CSV file: where it ends, its fields, its numbers.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace searig::acquisition {

/// Without spaces, tabs and carriage returns at either end.
std::string_view trimmed(std::string_view field);

/// The line that begins at `begin`, without its end; `next` is where the following one begins.
std::string_view line_at(std::string_view text, std::size_t begin, std::size_t& next);

/// The first of comma, semicolon and tab that the line has; a comma where it has none.
char separator_of(std::string_view line);

/// The names in a header line; quotes keep a separator inside a name.
std::vector<std::string> header_fields(std::string_view line, char separator);

/// What a field is: a finite number, or why not.
enum class Field { number, empty, text, not_finite };

constexpr std::size_t kNotAsked = static_cast<std::size_t>(-1);

/// What one line came to.
struct RowResult {
  std::size_t fields = 0;              ///< how many the line has
  std::size_t bad_column = kNotAsked;  ///< the first asked-for field that is no number
  Field bad = Field::number;           ///< and what it is instead
  std::string_view bad_text;
};

/// Splits the line once and parses what is asked for: slots[column] is where its value goes in
/// `values`, or kNotAsked.
RowResult parse_row(std::string_view line, char separator, std::span<const std::size_t> slots,
                    std::span<double> values);

/// Text from a file as it may stand in a sentence: printable, and not too long.
std::string quotable(std::string_view text, std::size_t longest);

/// Why the row's bad field is none: "'abc' is not a number".
std::string why_bad(const RowResult& row);

}  // namespace searig::acquisition
