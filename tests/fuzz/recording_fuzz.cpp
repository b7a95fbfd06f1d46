// The recording's reader under any bytes at all. The input is either a file as it stands, or a list
// of changes to a good one: then what is read must be an exact prefix of what was written.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "acquisition/recording/mcap/reader.h"
#include "acquisition/recording/mcap/recover.h"
#include "acquisition/recording/mcap/writer.h"

namespace {

using namespace searig::acquisition::mcap;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

/// Messages as one text each, in their order.
struct Messages : Handler {
  std::vector<std::string> all;
  void channel(const Channel&, const Schema&) override {}
  void message(const Message& message) override {
    all.push_back(std::to_string(message.channel) + " " + std::to_string(message.sequence) + " " +
                  std::to_string(message.log_time_ns) + " " + std::string(message.data));
  }
};

std::string good_file() {
  std::string bytes;
  Writer out([&](std::string_view piece) { bytes.append(piece); }, "fuzz");
  const auto a = out.add_channel("/a", "a", "float64 x\n");
  const auto b = out.add_channel("/b", "b", "string y\n", {{"key", "value"}});
  for (std::uint64_t i = 0; i < 40; ++i) {
    out.add(a, 1000 * i, "a" + std::to_string(i * i));
    if (i % 3 == 0) out.add(b, 1000 * i + 7, std::string(i, 'b'));
    if (i % 10 == 9) out.end_chunk();
  }
  out.attach({0, 0, "name", "text/plain", "content"});
  out.add_metadata("m", {{"k", "v"}});
  out.finish();
  return bytes;
}

const std::string good = good_file();

/// Each change is five bytes: what, and where or how much.
std::string changed(const std::uint8_t* data, std::size_t size) {
  std::string bytes = good;
  for (; size >= 5 && !bytes.empty(); data += 5, size -= 5) {
    const std::size_t at = (data[1] | data[2] << 8) % bytes.size();
    const std::size_t other = (data[3] | data[4] << 8) % bytes.size();
    switch (data[0] % 6) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << data[3] % 8));
        break;
      case 1:
        bytes[at] = static_cast<char>(data[3]);
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.erase(at, other % 64);
        break;
      case 4:
        bytes.insert(at, bytes.substr(other, data[3]));
        break;
      default:
        std::swap(bytes[at], bytes[other]);
    }
  }
  return bytes;
}

Messages messages_of(std::string_view bytes) {
  Messages messages;
  const Ending ending = read(bytes, messages);
  require(ending.valid_bytes <= bytes.size(), "valid bytes lie in the file");
  return messages;
}

void judge_recovery(std::string_view bytes, const Messages& read_before) {
  std::string whole;
  recover(bytes, "fuzz", [&](std::string_view piece) { whole.append(piece); });
  if (whole.empty()) return;
  Messages again;
  require(read(whole, again).end == End::whole, "what is recovered is whole");
  require(again.all.size() == read_before.all.size(), "recovered is what was read");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  if (data[0] % 8 == 0) {
    const std::string_view file(reinterpret_cast<const char*>(data + 1), size - 1);
    judge_recovery(file, messages_of(file));
    return 0;
  }
  static const Messages written = messages_of(good);
  const std::string file = changed(data + 1, size - 1);
  const Messages found = messages_of(file);
  require(found.all.size() <= written.all.size(), "no more than was written");
  for (std::size_t i = 0; i < found.all.size(); ++i)
    require(found.all[i] == written.all[i], "an exact prefix of what was written");
  judge_recovery(file, found);
  return 0;
}
