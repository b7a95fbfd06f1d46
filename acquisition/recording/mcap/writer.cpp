#include "acquisition/recording/mcap/writer.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace searig::acquisition::mcap {

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
  ChunkPlace place{from_ns, to_ns, offset_, bytes.size(), {}, 0, records_.size()};
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].empty()) continue;
    put(place.index_offsets, channels_[i].id);
    put(place.index_offsets, offset_ + bytes.size());
    std::string index;
    put(index, channels_[i].id);
    put(index, static_cast<std::uint32_t>(16 * entries_[i].size()));
    for (const Entry& entry : entries_[i]) {
      put(index, entry.log_time_ns);
      put(index, entry.offset);
    }
    put_record(bytes, Opcode::message_index, index);
  }

  place.index_length = bytes.size() - place.length;
  send(bytes);  // from here on nothing throws
  index_.add(place);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    index_.add_messages(i, entries_[i].size());
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
  index_.add(attachment, offset, bytes.size());
}

void Writer::add_metadata(const std::string& name, const Texts& texts) {
  end_chunk();
  std::string content, bytes;
  put_sized<std::uint32_t>(content, name);
  put_texts(content, texts);
  put_record(bytes, Opcode::metadata, content);
  const std::uint64_t offset = offset_;
  send(bytes);
  index_.add_metadata(name, offset, bytes.size());
}

void Writer::finish() {
  end_chunk();
  send(index_.ending(offset_, crc_, std::span(schemas_).first(channels_sent_),
                     std::span(channels_).first(channels_sent_)));
}

}  // namespace searig::acquisition::mcap
