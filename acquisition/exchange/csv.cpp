#include "acquisition/exchange/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "acquisition/error.h"
#include "acquisition/recording/text_file.h"

namespace searig::acquisition::exchange {
namespace {

constexpr std::size_t piece = 1 << 20;

/// Gathers rows and hands them on in pieces.
class Rows {
 public:
  explicit Rows(const Sink& sink) : sink_(sink) { text_.reserve(piece + 4096); }

  void line(std::string_view text) { text_.append(text) += '\n'; }
  void append(std::string_view text) { text_.append(text); }
  void append(char c) { text_ += c; }
  void append(double value) {
    if (!std::isnan(value)) append_number(text_, value);
  }
  void end_row() {
    text_ += '\n';
    if (text_.size() >= piece) send();
  }
  void send() {
    sink_(text_);
    text_.clear();
  }

 private:
  const Sink& sink_;
  std::string text_;
};

void head(Rows& rows, const Contents& contents) {
  rows.line(std::string(csv_first_line) + csv_name(contents.name));
  for (const std::string& clock : contents.clocks) rows.line("# " + clock);
}

void how(Rows& rows, const Column& column) {
  const std::string unit = column.unit == "1" ? "" : column.unit + ", ";
  rows.line("# " + csv_name(column.name) + ": " + unit + column.how);
}

}  // namespace

std::string csv_name(std::string_view name) {
  std::string out(name);
  const auto breaks = [](unsigned char c) { return c == ',' || c == '"' || c < 0x20; };
  std::replace_if(out.begin(), out.end(), breaks, '_');
  return out;
}

std::string csv_middle(std::string_view stream, std::string_view channel) {
  std::string out(1, ',');
  return out.append(csv_name(stream)).append(",").append(csv_name(channel)).append(",");
}

void write_csv_table(const Contents& contents, const Sink& sink) {
  const Group& table = contents.table;
  if (table.columns.empty())
    throw InputError("holds no load cell, whose times a table would be on; --long writes it all.");
  Rows rows(sink);
  head(rows, contents);
  for (const Column& column : table.columns) how(rows, column);
  std::string header;
  for (const Column& column : table.columns)
    header.append(header.empty() ? "" : ",").append(csv_name(column.name));
  rows.line(header);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const Column& column : table.columns) {
      if (&column != &table.columns.front()) rows.append(',');
      rows.append(column.values[row]);
    }
    rows.end_row();
  }
  rows.send();
}

namespace {

/// The columns whose values begin each row of a sample, where the group has them, and the others
/// with the text between.
struct LongForm {
  const Column* t_s = nullptr;
  const Column* device_t_s = nullptr;
  std::vector<const Column*> values;
  std::vector<std::string> middles;  ///< ",module,deflection_rad,"

  explicit LongForm(const Group& group)
      : t_s(group.find("t_s")), device_t_s(group.find("device_t_s")) {
    for (const Column& column : group.columns) {
      if (&column == t_s || &column == device_t_s) continue;
      values.push_back(&column);
      middles.push_back(csv_middle(group.name, column.name));
    }
  }
};

void write_group(Rows& rows, const Group& group) {
  const LongForm form(group);
  std::string begin;
  for (std::size_t row = 0; row < group.rows(); ++row) {
    begin.clear();
    if (form.t_s && !std::isnan(form.t_s->values[row])) append_number(begin, form.t_s->values[row]);
    begin += ',';
    if (form.device_t_s) append_number(begin, form.device_t_s->values[row]);
    for (std::size_t i = 0; i < form.values.size(); ++i) {
      rows.append(begin);
      rows.append(form.middles[i]);
      rows.append(form.values[i]->values[row]);
      rows.end_row();
    }
  }
}

}  // namespace

void write_csv_long(const Contents& contents, const Sink& sink) {
  Rows rows(sink);
  head(rows, contents);
  rows.line(std::string(csv_facts_line) + contents.facts);
  rows.line(
      "# t_s: s, on the module's clock; device_t_s: s, on the stream's own clock; units are in");
  rows.line("# the channels' names; nothing is interpolated and nothing left out");
  rows.line(csv_long_header);
  for (const Group& group : contents.groups) write_group(rows, group);
  rows.send();
}

}  // namespace searig::acquisition::exchange
