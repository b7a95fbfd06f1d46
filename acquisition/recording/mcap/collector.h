// What the messages of a recording's MCAP file hold, gathered by what they are for.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "acquisition/recording/mcap/reader.h"
#include "acquisition/recording/mcap/rows.h"
#include "acquisition/recording/mcap/settings.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition::mcap {

/// Sorts messages into what they are for; topics that are not known are for other programs.
class Collector : public Handler {
 public:
  std::optional<Settings> settings;
  std::vector<Event> events;
  ReceivedRows module, loadcell;
  std::map<std::string, Rows> devices;  ///< by topic

  /// The module's samples may be left out.
  explicit Collector(bool module_samples = true) : module_samples_(module_samples) {}

  void channel(const Channel& channel, const Schema& schema) override;
  void message(const Message& message) override;

 private:
  void rows_of(const Channel& channel, const Schema& schema, const std::string& topic,
               ReceivedRows& received);
  void rows_of(const Channel& channel, const Schema& schema, Rows& rows);
  void take_event(std::string_view data);

  bool module_samples_;
  std::map<std::uint16_t, Rows*> rows_;
  int settings_channel_ = -1, events_channel_ = -1;
};

/// The recording of all that was found in a file of so many bytes; it needs settings. Module and
/// load cell may be without samples.
Recording assembled(Collector& found, const Ending& ending, std::size_t size);

/// Path and name of a recording, and the path of its streams.
void name_after(const std::filesystem::path& path, Recording& recording);

}  // namespace searig::acquisition::mcap
