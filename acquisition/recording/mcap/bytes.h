// Little-endian numbers into and out of bytes, as MCAP and CDR have them.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace searig::acquisition::mcap {

static_assert(std::endian::native == std::endian::little, "MCAP is little-endian; so is this code");

template <typename Number>
concept Plain = std::integral<Number> || std::floating_point<Number>;

template <Plain Number>
void put(std::string& bytes, Number number) {
  char raw[sizeof number];
  std::memcpy(raw, &number, sizeof number);
  bytes.append(raw, sizeof raw);
}

/// A text or bytes with their length before them, counted in `Length`.
template <std::unsigned_integral Length>
void put_sized(std::string& bytes, std::string_view content) {
  put(bytes, static_cast<Length>(content.size()));
  bytes.append(content);
}

/// Takes numbers from the front. Where the bytes run out it yields zeros from then on and says so:
/// one look at ran_out() after a whole record is enough.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <Plain Number>
  Number take() {
    Number number{};
    const std::string_view raw = take_bytes(sizeof number);
    if (raw.size() == sizeof number) std::memcpy(&number, raw.data(), sizeof number);
    return number;
  }

  std::string_view take_bytes(std::uint64_t count) {
    if (count > rest_.size()) {
      ran_out_ = true;
      rest_ = {};
      return {};
    }
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  template <std::unsigned_integral Length>
  std::string_view take_sized() {
    return take_bytes(take<Length>());
  }

  bool ran_out() const { return ran_out_; }
  bool empty() const { return rest_.empty(); }
  std::size_t size() const { return rest_.size(); }

 private:
  std::string_view rest_;
  bool ran_out_ = false;
};

}  // namespace searig::acquisition::mcap
