#include "acquisition/recording/mcap/writer.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace searig::acquisition::mcap {
namespace {}  // namespace

Writer::Writer(Sink sink, const std::string& library) : sink_(std::move(sink)) {
  std::string bytes(magic);
  std::string header;
  put_sized<std::uint32_t>(header, "");  // no profile of ROS's: the messages are of our own
  put_sized<std::uint32_t>(header, library);
  put_record(bytes, Opcode::header, header);
  send(bytes);
}

void Writer::send(std::string_view bytes) {
  sink_(bytes);
  offset_ += bytes.size();
  crc_ = crc32_of(bytes, crc_);
}

std::uint16_t Writer::add_channel(const std::string& topic, const std::string& schema_name,
                                  const std::string& schema_text, const Texts& metadata) {
  return add_channel(Channel{0, 0, topic, "cdr", metadata},
                     Schema{0, schema_name, "ros2msg", schema_text});
}

std::uint16_t Writer::add_channel(Channel channel, Schema schema) {
  channel.id = channel.schema = schema.id = static_cast<std::uint16_t>(channels_.size() + 1);
  schemas_.push_back(std::move(schema));
  channels_.push_back(std::move(channel));
  sequence_.push_back(0);
  messages_.push_back(0);
  entries_.emplace_back();
  return channels_.back().id;
}

void Writer::add(std::uint16_t channel, std::uint64_t log_time_ns, std::string_view data) {
  for (; channels_sent_ < channels_.size(); ++channels_sent_) {
    put_schema(records_, schemas_[channels_sent_]);
    put_channel(records_, channels_[channels_sent_]);
  }
  const std::size_t i = channel - 1u;
  entries_[i].push_back({log_time_ns, records_.size()});
  put_message(records_, {channel, sequence_[i]++, log_time_ns, log_time_ns, data});
}

std::string Writer::chunk_record(std::uint64_t from_ns, std::uint64_t to_ns) const {
  std::string content;
  content.reserve(records_.size() + 64);
  put(content, from_ns);
  put(content, to_ns);
  put(content, std::uint64_t(records_.size()));
  put(content, crc32_of(records_));
  put_sized<std::uint32_t>(content, "");  // not compressed
  put_sized<std::uint64_t>(content, records_);
  std::string bytes;
  put_record(bytes, Opcode::chunk, content);
  return bytes;
}

void Writer::end_chunk() {
  if (records_.empty()) return;
  std::uint64_t from_ns = std::numeric_limits<std::uint64_t>::max(), to_ns = 0;
  for (const auto& channel : entries_)
    for (const Entry& entry : channel) {
      from_ns = std::min(from_ns, entry.log_time_ns);
      to_ns = std::max(to_ns, entry.log_time_ns);
    }
  std::string bytes = chunk_record(from_ns, to_ns);
  const std::uint64_t chunk_length = bytes.size();

  std::string index_offsets;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].empty()) continue;
    put(index_offsets, channels_[i].id);
    put(index_offsets, offset_ + bytes.size());
    std::string index;
    put(index, channels_[i].id);
    put(index, static_cast<std::uint32_t>(16 * entries_[i].size()));
    for (const Entry& entry : entries_[i]) {
      put(index, entry.log_time_ns);
      put(index, entry.offset);
    }
    put_record(bytes, Opcode::message_index, index);
  }

  const std::uint64_t chunk_offset = offset_;
  send(bytes);  // from here on nothing throws

  std::string index;
  put(index, from_ns);
  put(index, to_ns);
  put(index, chunk_offset);
  put(index, chunk_length);
  put_sized<std::uint32_t>(index, index_offsets);
  put(index, std::uint64_t(bytes.size()) - chunk_length);
  put_sized<std::uint32_t>(index, "");
  put(index, std::uint64_t(records_.size()));
  put(index, std::uint64_t(records_.size()));
  put_record(chunk_indexes_, Opcode::chunk_index, index);

  from_ns_ = chunks_ == 0 ? from_ns : std::min(from_ns_, from_ns);
  to_ns_ = std::max(to_ns_, to_ns);
  ++chunks_;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    messages_[i] += entries_[i].size();
    entries_[i].clear();
  }
  records_.clear();
}

void Writer::attach(const Attachment& attachment) {
  end_chunk();
  std::string bytes;
  put_attachment(bytes, attachment);
  const std::uint64_t offset = offset_;
  send(bytes);
  std::string index;
  put(index, offset);
  put(index, std::uint64_t(bytes.size()));
  put(index, attachment.log_time_ns);
  put(index, attachment.made_time_ns);
  put(index, std::uint64_t(attachment.data.size()));
  put_sized<std::uint32_t>(index, attachment.name);
  put_sized<std::uint32_t>(index, attachment.media_type);
  put_record(attachment_indexes_, Opcode::attachment_index, index);
  ++attachments_;
}

void Writer::add_metadata(const std::string& name, const Texts& texts) {
  end_chunk();
  std::string content, bytes;
  put_sized<std::uint32_t>(content, name);
  put_texts(content, texts);
  put_record(bytes, Opcode::metadata, content);
  const std::uint64_t offset = offset_;
  send(bytes);
  std::string index;
  put(index, offset);
  put(index, std::uint64_t(bytes.size()));
  put_sized<std::uint32_t>(index, name);
  put_record(metadata_indexes_, Opcode::metadata_index, index);
  ++metadata_;
}

std::string Writer::statistics() const {
  std::string counts, content, bytes;
  for (std::size_t i = 0; i < channels_sent_; ++i) {
    put(counts, channels_[i].id);
    put(counts, messages_[i]);
  }
  put(content, std::accumulate(messages_.begin(), messages_.end(), std::uint64_t{0}));
  put(content, static_cast<std::uint16_t>(channels_sent_));
  put(content, static_cast<std::uint32_t>(channels_sent_));
  put(content, attachments_);
  put(content, metadata_);
  put(content, chunks_);
  put(content, from_ns_);
  put(content, to_ns_);
  put_sized<std::uint32_t>(content, counts);
  put_record(bytes, Opcode::statistics, content);
  return bytes;
}

void Writer::finish() {
  end_chunk();
  std::string bytes, crc;
  put(crc, crc_);
  put_record(bytes, Opcode::data_end, crc);
  const std::uint64_t summary_start = offset_ + bytes.size();

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
  std::string schemas, channels;
  for (std::size_t i = 0; i < channels_sent_; ++i) {
    put_schema(schemas, schemas_[i]);
    put_channel(channels, channels_[i]);
  }
  group(Opcode::schema, schemas);
  group(Opcode::channel, channels);
  group(Opcode::statistics, statistics());
  group(Opcode::chunk_index, chunk_indexes_);
  group(Opcode::attachment_index, attachment_indexes_);
  group(Opcode::metadata_index, metadata_indexes_);
  const std::uint64_t offsets_start = summary_start + summary.size();
  summary += offsets;

  // The summary's CRC covers the footer as well, up to the CRC itself.
  put(summary, static_cast<std::uint8_t>(Opcode::footer));
  put(summary, std::uint64_t{8 + 8 + 4});
  put(summary, summary_start);
  put(summary, offsets_start);
  put(summary, crc32_of(summary));
  send(bytes + summary + std::string(magic));
}

}  // namespace searig::acquisition::mcap
