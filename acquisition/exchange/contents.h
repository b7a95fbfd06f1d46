// What an export holds: every stream at its own times, and one table at the load cell's.
#pragma once

#include <list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition::exchange {

struct Column {
  std::string name;  ///< "deflection_rad"
  std::string unit;  ///< "rad"
  std::string how;   ///< "linear between the module's rows around t_s"
  std::span<const double> values;
};

/// Columns of one length.
struct Group {
  std::string name;   ///< "module", "loadcell", "device.encoder", "module.pings", "table"
  std::string about;  ///< one sentence
  std::vector<Column> columns;

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
  const Column* find(std::string_view column) const;
};

/// A recording laid out for other programs. Streams have their rows as received, none left out:
/// t_s (module's clock; NaN where a run could not be placed), device_t_s (their own clock), host_s,
/// then the channels. Values are views: the recording must outlive this.
struct Contents {
  std::string name;                 ///< the recording's
  std::vector<std::string> clocks;  ///< for people: how each stream came to the module's clock
  std::string facts;                ///< what is no column, as JSON in ASCII (facts.h)
  std::vector<Group> groups;        ///< streams, then their pings
  Group table;  ///< a row for each load-cell sample (table.h); no columns without one

  std::list<std::vector<double>> made;  ///< what the recording does not hold itself
  std::span<const double> keep(std::vector<double> values);
};

/// `devices` are the clocks of recording.devices, in their order.
Contents contents_of(const Recording& recording, const ClockMap& clock,
                     const std::vector<ClockMap>& devices);

/// The names as other programs can have them: letters, digits and underscores, at most 60 of them,
/// each once.
std::vector<std::string> identifiers(const std::vector<std::string>& names);

/// Of groups or of columns.
template <typename Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

}  // namespace searig::acquisition::exchange
