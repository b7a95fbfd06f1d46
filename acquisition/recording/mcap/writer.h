// Writes an MCAP file, append only: valid up to its last whole chunk at any moment.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "acquisition/recording/mcap/format.h"
#include "acquisition/recording/mcap/index.h"

namespace searig::acquisition::mcap {

/// Messages are gathered into a chunk, which goes out in one piece with its CRC, uncompressed;
/// schemas and channels stand in the chunk of their first message, so nothing that is needed to
/// read lies outside a CRC.
class Writer {
 public:
  /// Takes all bytes or throws; after a throw the file ends where it ended before.
  using Sink = std::function<void(std::string_view)>;

  Writer(Sink sink, const std::string& library);

  /// A channel of CDR messages that a ROS 2 message definition describes (see cdr.h).
  std::uint16_t add_channel(const std::string& topic, const std::string& schema_name,
                            const std::string& schema_text, const Texts& metadata = {});

  /// A channel as another file has it; its id and its schema's are given anew.
  std::uint16_t add_channel(Channel channel, Schema schema);

  void add(std::uint16_t channel, std::uint64_t log_time_ns, std::string_view data);

  std::size_t bytes_waiting() const { return records_.size(); }

  /// Sends the chunk out; nothing where no message waits. After a throw the chunk waits still.
  void end_chunk();

  void attach(const Attachment& attachment);

  /// For other programs to show; no CRC guards it, so nothing here relies on it.
  void add_metadata(const std::string& name, const Texts& texts);

  /// The index at the end, with which other programs open the file at once.
  void finish();

  std::uint64_t bytes_written() const { return offset_; }

 private:
  struct Entry {
    std::uint64_t log_time_ns = 0;
    std::uint64_t offset = 0;
  };

  void send(std::string_view bytes);
  std::string chunk_record(std::uint64_t from_ns, std::uint64_t to_ns) const;

  Sink sink_;
  std::uint64_t offset_ = 0;
  std::uint32_t crc_ = 0;  // of all sent so far

  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  std::size_t channels_sent_ = 0;        // those before are in the file or in the chunk that waits
  std::vector<std::uint32_t> sequence_;  // next one of each channel

  std::string records_;                      // the chunk that waits
  std::vector<std::vector<Entry>> entries_;  // and its index, by channel

  Index index_;  // for the end
};

}  // namespace searig::acquisition::mcap
