#include "acquisition/recording/mcap/read_mcap.h"

#include <fstream>

#include "acquisition/error.h"
#include "acquisition/recording/mapped_file.h"
#include "acquisition/recording/mcap/cdr.h"
#include "acquisition/recording/mcap/collector.h"
#include "acquisition/recording/mcap/layout.h"

namespace searig::acquisition::mcap {
namespace {

/// The last settings, nothing else.
class SettingsCollector : public Handler {
 public:
  std::optional<Settings> settings;

  void channel(const Channel& channel, const Schema&) override {
    if (channel.topic == settings_topic) channel_ = channel.id;
  }
  void message(const Message& message) override {
    if (message.channel == channel_) settings = settings_from_json(CdrReader(message.data).text());
  }

 private:
  int channel_ = -1;
};

}  // namespace

bool is_mcap(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  if (path.extension() == ".mcap") return true;
  std::string first(magic.size(), '\0');
  std::ifstream(path, std::ios::binary).read(first.data(), std::streamsize(first.size()));
  return first == magic;
}

std::string cut_off(const Ending& ending, std::size_t size) {
  if (ending.end == End::whole) return {};
  const std::string sentence = "The file " + ending.why;
  if (ending.end == End::index) return sentence + "; all its data are there.";
  const std::size_t left_out = size - ending.valid_bytes;
  if (left_out == 0) return sentence + "; everything up to its end is there.";
  return sentence + "; " + std::to_string(left_out) + " bytes behind what is whole are left out.";
}

Recording recording_of(std::string_view bytes, const std::string& name) {
  Collector found;
  Ending ending;
  try {
    ending = read(bytes, found);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
  if (ending.end == End::unfit) throw InputError(name + ": " + ending.why + ".");
  if (!found.settings)
    throw InputError(name + ": " +
                     (ending.all_data() ? "is an MCAP file, but no recording of searig's."
                                        : ending.why + "; nothing before that can be read."));
  Recording recording = assembled(found, ending, bytes.size());
  const auto& loadcell = found.settings->loadcell.sorted;
  refuse_unusable(recording, loadcell && loadcell->counts.received == 0, name);
  return recording;
}

Recording read_mcap(const std::filesystem::path& path) {
  const MappedFile file(path);
  Recording recording = recording_of(file.bytes(), path.string());
  name_after(path, recording);
  return recording;
}

Settings read_settings(const std::filesystem::path& path) {
  const MappedFile file(path);
  SettingsCollector found;
  try {
    read(file.bytes(), found);
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
  if (!found.settings) throw InputError(path.string() + ": is no recording of searig's.");
  return *found.settings;
}

}  // namespace searig::acquisition::mcap
