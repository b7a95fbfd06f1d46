// What stands behind a file's data, with which other programs open it at once.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "acquisition/recording/mcap/format.h"

namespace searig::acquisition::mcap {

/// A chunk as it went out: where it lies, and where behind it the messages of each channel are
/// listed.
struct ChunkPlace {
  std::uint64_t from_ns = 0, to_ns = 0;
  std::uint64_t offset = 0, length = 0;
  std::string index_offsets;  ///< channel and offset, one after the other
  std::uint64_t index_length = 0;
  std::uint64_t records_length = 0;
};

class Index {
 public:
  void add(const ChunkPlace& chunk);
  void add_messages(std::size_t channel, std::uint64_t count);
  void add(const Attachment& attachment, std::uint64_t offset, std::uint64_t length);
  void add_metadata(const std::string& name, std::uint64_t offset, std::uint64_t length);

  /// Everything from the end of the data on. offset, crc: of all that went out before; channels:
  /// those that are in the file, with the schema of each.
  std::string ending(std::uint64_t offset, std::uint32_t crc, std::span<const Schema> schemas,
                     std::span<const Channel> channels) const;

 private:
  std::string statistics(std::span<const Channel> channels) const;

  std::string chunks_, attachments_, metadata_;  // records, ready for the end
  std::uint32_t chunk_count_ = 0, attachment_count_ = 0, metadata_count_ = 0;
  std::vector<std::uint64_t> messages_;  // of each channel
  std::uint64_t from_ns_ = 0, to_ns_ = 0;
};

}  // namespace searig::acquisition::mcap
