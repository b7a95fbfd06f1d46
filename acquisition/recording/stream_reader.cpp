#include "acquisition/recording/stream_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "acquisition/clock/device_clock.h"
#include "acquisition/error.h"

namespace searig::acquisition {
namespace {

constexpr std::array<std::string_view, 9> kModuleChannels = {
    "input_angle_rad",     "output_angle_rad",    "deflection_rad",       "current_a",
    "motor_angle_rad",     "commanded_angle_rad", "input_velocity_rad_s", "winding_temperature_c",
    "spring_temperature_c"};
constexpr std::array<std::string_view, 2> kLoadcellChannels = {"force_n", "torque_nm"};

/// The columns of a native file are those channels of its stream that its header names.
std::vector<ColumnMapping> native_columns(const CsvFile& file, const std::string& stream) {
  std::vector<ColumnMapping> columns;
  const auto take = [&](std::string_view channel) {
    if (file.find(channel) < file.header().size())
      columns.push_back({std::string(channel), std::string(channel), 1.0, 0.0, {}});
  };
  for (const std::string_view channel : {"t_s", "host_s", "seq"}) take(channel);
  if (stream == "loadcell")
    for (const std::string_view channel : kLoadcellChannels) take(channel);
  else  // the module, or a device that supplies what the module lacks
    for (const std::string_view channel : kModuleChannels) take(channel);
  return columns;
}

std::vector<std::size_t> column_numbers(const CsvFile& file,
                                        const std::vector<ColumnMapping>& columns) {
  std::vector<std::size_t> numbers;
  for (const ColumnMapping& column : columns) {
    if (const auto* name = std::get_if<std::string>(&column.column)) {
      numbers.push_back(file.find(*name));
      if (numbers.back() == file.header().size()) file.refuse_missing(*name);
    } else {
      numbers.push_back(std::get<std::size_t>(column.column));
    }
  }
  return numbers;
}

void to_si(std::vector<double>& values, const ColumnMapping& column) {
  for (double& value : values) {
    if (column.wraps_at && value >= 0.5 * *column.wraps_at) value -= *column.wraps_at;
    value = column.scale * value + column.offset;
  }
}

std::vector<double> picked(const std::vector<double>& values,
                           const std::vector<std::size_t>& order) {
  std::vector<double> result(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) result[i] = values[order[i]];
  return result;
}

void refuse_unsorted(const CsvFile& file, const CsvRows& rows, const ClockedRows& clocked,
                     std::size_t clock_column) {
  const std::size_t all = rows.lines.size();
  if (clocked.misplaced <= all / 50 && clocked.doubled <= all / 2) return;
  throw InputError(file.path().string() + ", line " +
                   std::to_string(rows.lines[clocked.first_not_rising]) + ", " +
                   file.column_name(clock_column) +
                   ": the clock is not sorted, it does not rise here nor in " +
                   std::to_string(clocked.misplaced + clocked.doubled) + " rows in all.");
}

CsvFile file_of(const StreamMapping& mapping) {
  const bool by_number =
      !mapping.native && std::all_of(mapping.columns.begin(), mapping.columns.end(), [](auto& c) {
        return std::holds_alternative<std::size_t>(c.column);
      });
  return {mapping.file, !by_number};
}

/// The clock first.
std::vector<ColumnMapping> columns_of(const StreamMapping& mapping, const CsvFile& file) {
  std::vector<ColumnMapping> columns =
      mapping.native ? native_columns(file, mapping.name) : mapping.columns;
  if (const std::string missing = missing_channel(mapping, columns); !missing.empty())
    file.refuse_missing(missing);
  std::partition(columns.begin(), columns.end(), [](auto& c) { return c.channel == "t_s"; });
  return columns;
}

}  // namespace

StreamPieces::StreamPieces(const StreamMapping& mapping)
    : file_(file_of(mapping)), columns_(columns_of(mapping, file_)) {
  column_numbers(file_, columns_);  // refuses what is missing
}

bool StreamPieces::has(std::string_view channel) const {
  return std::ranges::find(columns_, channel, &ColumnMapping::channel) != columns_.end();
}

void StreamPieces::go_through(const std::vector<std::string>& channels,
                              const ModuleRows::Take& take) const {
  const auto wanted = [&](const ColumnMapping& column) {
    return column.channel == "t_s" || column.channel == "host_s" ||
           std::ranges::find(channels, column.channel) != channels.end();
  };
  std::vector<ColumnMapping> columns;
  for (const ColumnMapping& column : columns_)
    if (!checked_ || wanted(column)) columns.push_back(column);
  Stream piece;
  double last_s = -HUGE_VAL, last_seq = NAN;
  const auto check = [&](const std::vector<double>& seq) {
    for (const double t : piece.t_s) {
      if (!(t > last_s)) throw NotInOrder();
      last_s = t;
    }
    for (const double number : seq) {
      if (number == last_seq) throw NotInOrder();
      last_seq = number;
    }
  };
  static const std::vector<double> none;
  const bool clean = file_.read_pieces(column_numbers(file_, columns), [&](CsvRows& rows) {
    piece.channels.clear();
    const std::vector<double>* seq = &none;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      to_si(rows.columns[i], columns[i]);
      if (columns[i].channel == "seq") seq = &rows.columns[i];
      if (columns[i].channel == "t_s")
        piece.t_s = rows.columns[i];
      else if (columns[i].channel == "host_s")
        piece.host_s = rows.columns[i];
      else if (wanted(columns[i]))
        piece.channels.push_back({columns[i].channel, rows.columns[i]});
    }
    check(*seq);
    take(piece);
  });
  if (!clean) throw NotInOrder();
  checked_ = true;
}

Stream read_stream(const StreamMapping& mapping) {
  const CsvFile file = file_of(mapping);
  const std::vector<ColumnMapping> columns = columns_of(mapping, file);
  const std::vector<std::size_t> numbers = column_numbers(file, columns);
  CsvRows rows = file.read(numbers, mapping.faults);
  for (std::size_t i = 0; i < columns.size(); ++i) to_si(rows.columns[i], columns[i]);

  const auto values = [&](std::string_view channel) -> const std::vector<double>& {
    static const std::vector<double> none;
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i].channel == channel) return rows.columns[i];
    return none;
  };
  ClockedRows clocked = read_device_clock(values("t_s"), values("host_s"), values("seq"));
  refuse_unsorted(file, rows, clocked, numbers[0]);

  Stream stream;
  stream.name = mapping.name;
  stream.file = mapping.file;
  stream.host_latency = mapping.host_latency;
  stream.t_s = std::move(clocked.t_s);
  stream.restarts = std::move(clocked.restarts);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].channel == "t_s") continue;
    std::vector<double> kept = picked(rows.columns[i], clocked.order);
    if (columns[i].channel == "host_s")
      stream.host_s = std::move(kept);
    else
      stream.channels.push_back({columns[i].channel, std::move(kept)});
  }
  stream.counts = {clocked.order.size(), clocked.lost, clocked.doubled,
                   rows.garbled + clocked.astray, clocked.out_of_order};
  return stream;
}

}  // namespace searig::acquisition
