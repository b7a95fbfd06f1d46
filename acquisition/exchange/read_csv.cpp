#include "acquisition/exchange/read_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/exchange/csv.h"
#include "acquisition/exchange/facts.h"
#include "acquisition/recording/csv_row.h"
#include "acquisition/recording/mapped_file.h"

namespace searig::acquisition::exchange {
namespace {

/// Lines of a text, and the sentence that names one.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  bool at_end() const { return next_ == text_.size(); }
  std::string_view next() {
    ++number_;
    return line_at(text_, next_, next_);
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError("line " + std::to_string(number_) + ": " + what + ".");
  }

 private:
  std::string_view text_;
  std::size_t next_ = 0, number_ = 0;
};

/// Reads up to the header and gives the facts.
std::string_view facts_above(Lines& lines) {
  std::string_view facts;
  while (!lines.at_end()) {
    const std::string_view line = lines.next();
    if (line.starts_with(csv_facts_line)) facts = line.substr(csv_facts_line.size());
    if (line.starts_with('#')) continue;
    if (line != csv_long_header || facts.empty())
      lines.refuse(
          "this is no export in the long form (searig export --long), which alone can be "
          "read back");
    return facts;
  }
  lines.refuse("the header is missing");
}

double number(std::string_view field, const Lines& lines) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || !std::isfinite(value))
    lines.refuse("'" + quotable(field, 40) + "' is not a number");
  return value;
}

/// What follows "t_s," in each row of a group: ",stream,channel," and where its value goes.
struct Expected {
  std::string middle;
  std::vector<double>* values = nullptr;
};

/// One sample: a row for each of `expected`, all of one moment.
void read_sample(Lines& lines, const std::vector<Expected>& expected,
                 std::vector<double>* device_t_s) {
  std::string_view moment;
  for (const Expected& one : expected) {
    if (lines.at_end()) lines.refuse("the file ends within a sample");
    const std::string_view line = lines.next();
    const std::size_t first = line.find(',');
    const std::size_t second = first == line.npos ? line.npos : line.find(',', first + 1);
    if (second == line.npos || !line.substr(second).starts_with(one.middle))
      lines.refuse("here belongs a row of " + one.middle.substr(1, one.middle.size() - 2));
    const std::string_view begin = line.substr(0, second);
    if (&one == &expected.front()) {
      moment = begin;
      if (device_t_s) device_t_s->push_back(number(begin.substr(first + 1), lines));
    } else if (begin != moment) {
      lines.refuse("the sample's other rows are of another time");
    }
    one.values->push_back(number(line.substr(second + one.middle.size()), lines));
  }
}

void read_group(Lines& lines, ReadGroup& group) {
  std::vector<Expected> expected;
  std::vector<double>* device_t_s = nullptr;
  for (Channel& column : group.columns) {
    if (column.name == "t_s") continue;
    if (column.name == "device_t_s")
      device_t_s = &column.values;
    else
      expected.push_back({csv_middle(group.name, column.name), &column.values});
  }
  for (std::size_t row = 0; row < group.rows; ++row) read_sample(lines, expected, device_t_s);
}

Recording read(std::string_view text) {
  Lines lines(text);
  const std::string_view facts = facts_above(lines);
  std::vector<ReadGroup> groups = groups_of(facts);
  for (ReadGroup& group : groups) read_group(lines, group);
  if (!lines.at_end()) {
    lines.next();
    lines.refuse("there are more rows than the facts tell of");
  }
  return recording_of(facts, std::move(groups));
}

}  // namespace

Recording read_csv_long(const std::filesystem::path& path) {
  const MappedFile file(path);
  try {
    return read(file.bytes());
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace searig::acquisition::exchange
