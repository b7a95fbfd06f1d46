// Messages as CDR (the encoding of ROS 2), which Foxglove and PlotJuggler decode by their schema.
#pragma once

#include <string>
#include <string_view>

#include "acquisition/recording/mcap/bytes.h"

namespace searig::acquisition::mcap {

inline constexpr std::string_view cdr_head{"\0\1\0\0", 4};  // plain CDR, little-endian

/// Fields one after the other, each number aligned to its own size, counted after the head.
class CdrWriter {
 public:
  CdrWriter() : bytes_(cdr_head) {}

  template <Plain Number>
  CdrWriter& operator<<(Number number) {
    align(sizeof number);
    put(bytes_, number);
    return *this;
  }

  CdrWriter& operator<<(std::string_view text) {  // its length counts the zero at its end
    *this << static_cast<std::uint32_t>(text.size() + 1);
    bytes_.append(text).push_back('\0');
    return *this;
  }

  /// A sequence of bytes: uint8[].
  CdrWriter& raw(std::string_view content) {
    *this << static_cast<std::uint32_t>(content.size());
    bytes_.append(content);
    return *this;
  }

  std::string_view bytes() const { return bytes_; }

 private:
  void align(std::size_t size) {
    while ((bytes_.size() - cdr_head.size()) % size != 0) bytes_.push_back('\0');
  }

  std::string bytes_;
};

/// The way back. ran_out() tells, once at the end, that there was less than was asked for.
class CdrReader {
 public:
  explicit CdrReader(std::string_view message) : reader_(message), size_(message.size()) {
    fits_ = reader_.take_bytes(cdr_head.size()) == cdr_head;
  }

  template <Plain Number>
  Number number() {
    while (!reader_.ran_out() && (size_ - reader_.size() - cdr_head.size()) % sizeof(Number) != 0)
      reader_.take_bytes(1);
    return reader_.take<Number>();
  }

  std::string_view raw() { return reader_.take_bytes(number<std::uint32_t>()); }

  std::string_view text() {
    std::string_view content = raw();
    if (!content.empty()) content.remove_suffix(1);
    return content;
  }

  /// Whether it was plain CDR and exactly what was asked for.
  bool fits() const { return fits_ && !reader_.ran_out() && reader_.empty(); }

 private:
  ByteReader reader_;
  std::size_t size_;
  bool fits_;
};

}  // namespace searig::acquisition::mcap
