#include "acquisition/recording/mcap/index.h"

#include <algorithm>
#include <numeric>

namespace searig::acquisition::mcap {

void Index::add(const ChunkPlace& chunk) {
  std::string index;
  put(index, chunk.from_ns);
  put(index, chunk.to_ns);
  put(index, chunk.offset);
  put(index, chunk.length);
  put_sized<std::uint32_t>(index, chunk.index_offsets);
  put(index, chunk.index_length);
  put_sized<std::uint32_t>(index, "");  // not compressed, so it is as long as its records
  put(index, chunk.records_length);
  put(index, chunk.records_length);
  put_record(chunks_, Opcode::chunk_index, index);
  from_ns_ = chunk_count_ == 0 ? chunk.from_ns : std::min(from_ns_, chunk.from_ns);
  to_ns_ = std::max(to_ns_, chunk.to_ns);
  ++chunk_count_;
}

void Index::add_messages(std::size_t channel, std::uint64_t count) {
  if (messages_.size() <= channel) messages_.resize(channel + 1);
  messages_[channel] += count;
}

void Index::add(const Attachment& attachment, std::uint64_t offset, std::uint64_t length) {
  std::string index;
  put(index, offset);
  put(index, length);
  put(index, attachment.log_time_ns);
  put(index, attachment.made_time_ns);
  put(index, std::uint64_t(attachment.data.size()));
  put_sized<std::uint32_t>(index, attachment.name);
  put_sized<std::uint32_t>(index, attachment.media_type);
  put_record(attachments_, Opcode::attachment_index, index);
  ++attachment_count_;
}

void Index::add_metadata(const std::string& name, std::uint64_t offset, std::uint64_t length) {
  std::string index;
  put(index, offset);
  put(index, length);
  put_sized<std::uint32_t>(index, name);
  put_record(metadata_, Opcode::metadata_index, index);
  ++metadata_count_;
}

std::string Index::statistics(std::span<const Channel> channels) const {
  std::string counts, content, bytes;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    put(counts, channels[i].id);
    put(counts, i < messages_.size() ? messages_[i] : std::uint64_t{0});
  }
  put(content, std::accumulate(messages_.begin(), messages_.end(), std::uint64_t{0}));
  put(content, static_cast<std::uint16_t>(channels.size()));
  put(content, static_cast<std::uint32_t>(channels.size()));
  put(content, attachment_count_);
  put(content, metadata_count_);
  put(content, chunk_count_);
  put(content, from_ns_);
  put(content, to_ns_);
  put_sized<std::uint32_t>(content, counts);
  put_record(bytes, Opcode::statistics, content);
  return bytes;
}

std::string Index::ending(std::uint64_t offset, std::uint32_t data_crc,
                          std::span<const Schema> schemas,
                          std::span<const Channel> channels) const {
  std::string bytes, crc;
  put(crc, data_crc);
  put_record(bytes, Opcode::data_end, crc);
  const std::uint64_t summary_start = offset + bytes.size();

  std::string summary, offsets;
  const auto group = [&](Opcode opcode, const std::string& records) {
    if (records.empty()) return;
    std::string content;
    put(content, static_cast<std::uint8_t>(opcode));
    put(content, summary_start + summary.size());
    put(content, std::uint64_t(records.size()));
    put_record(offsets, Opcode::summary_offset, content);
    summary += records;
  };
  std::string schema_records, channel_records;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    put_schema(schema_records, schemas[i]);
    put_channel(channel_records, channels[i]);
  }
  group(Opcode::schema, schema_records);
  group(Opcode::channel, channel_records);
  group(Opcode::statistics, statistics(channels));
  group(Opcode::chunk_index, chunks_);
  group(Opcode::attachment_index, attachments_);
  group(Opcode::metadata_index, metadata_);
  const std::uint64_t offsets_start = summary_start + summary.size();
  summary += offsets;

  // The summary's CRC covers the footer as well, up to the CRC itself.
  put(summary, static_cast<std::uint8_t>(Opcode::footer));
  put(summary, std::uint64_t{8 + 8 + 4});
  put(summary, summary_start);
  put(summary, offsets_start);
  put(summary, crc32_of(summary));
  return bytes + summary + std::string(magic);
}

}  // namespace searig::acquisition::mcap
