// The decoder under any bytes at all. The input is a little script, so that it gets past the CRC:
// raw bytes, good frames with any header, damaged ones, gaps, time that passes.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <tuple>
#include <vector>

#include "acquisition/wire/decoder.h"

namespace {

using namespace searig::acquisition;
namespace wire = searig::wire;

/// The script's bytes, and zeros behind its end.
class Script {
 public:
  Script(const std::uint8_t* data, std::size_t size) : data_(data), end_(data + size) {}
  bool ended() const { return data_ == end_; }
  std::uint8_t byte() { return ended() ? 0 : *data_++; }
  std::uint32_t word() {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | byte();
    return value;
  }

 private:
  const std::uint8_t* data_;
  const std::uint8_t* end_;
};

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

std::vector<std::uint8_t> good_frame(Script& script, wire::Header& header) {
  const std::uint8_t choice = script.byte();
  header.version = choice % 16 == 0 ? script.byte() : wire::kProtocolVersion;
  header.type = static_cast<wire::Type>(choice % 11 == 0 ? script.byte() : 1 + choice % 4);
  header.sequence = choice < 8 ? script.word() : header.sequence + choice % 3;
  header.time_us = choice < 16 ? script.word() : header.time_us + 1000u * choice;
  header.boot = choice % 29 == 0 ? script.byte() : header.boot;
  const int known = wire::payload_size(header.type);
  const std::size_t size = known < 0 || choice % 37 == 0 ? script.byte() % (wire::kMaxPayload + 1)
                                                         : static_cast<std::size_t>(known);
  std::uint8_t payload[wire::kMaxPayload];
  for (auto& byte : payload) byte = script.byte();
  std::vector<std::uint8_t> bytes(wire::kMaxEncoded);
  bytes.resize(wire::encode(header, payload, size, bytes.data()));
  return bytes;
}

/// What must hold of every message: no sample comes twice, and time is a finite number.
class Judge {
 public:
  void judge(const std::vector<Message>& messages) {
    for (const Message& message : messages) {
      if (const auto* restart = std::get_if<Restart>(&message)) {
        require(restart->run == run_ + 1, "runs are numbered one by one");
        run_ = restart->run;
      } else if (const auto* sample = std::get_if<LoadcellSample>(&message)) {
        once(0, sample->at);
      } else if (const auto* other = std::get_if<ModuleSample>(&message)) {
        once(1, other->at);
      }
    }
  }

 private:
  void once(int type, const Stamp& at) {
    require(at.run == run_, "a sample belongs to the run that was announced");
    require(at.device_s == at.device_s && at.host_s == at.host_s, "times are numbers");
    require(seen_.insert({type, at.run, at.sequence}).second, "no sample comes twice");
  }

  std::uint32_t run_ = 0;
  std::set<std::tuple<int, std::uint32_t, std::uint32_t>> seen_;
};

void follow(Script script, Framing framing) {
  Decoder whole(framing), cut(framing);
  std::vector<Message> messages, same;
  Judge judge;
  wire::Header header{};
  double host_s = 0.0;
  while (!script.ended()) {
    const std::uint8_t step = script.byte();
    std::vector<std::uint8_t> bytes;
    if (step < 160) {
      bytes = good_frame(script, header);
      if (step < 16) bytes[script.byte() % bytes.size()] ^= static_cast<std::uint8_t>(1 + step);
    } else if (step < 200) {
      for (int i = script.byte() % 100; i > 0; --i) bytes.push_back(script.byte());
    } else if (step < 210) {
      whole.gap();
      cut.gap();
    } else {
      host_s += script.byte() * (step < 250 ? 1e-3 : 60.0);
    }
    messages.clear();
    same.clear();
    whole.push(bytes, host_s, messages);
    judge.judge(messages);
    if (framing == Framing::datagrams) continue;
    for (const std::uint8_t byte : bytes) cut.push({&byte, 1}, host_s, same);
    require(same.size() == messages.size(), "messages do not depend on how reads are cut");
  }
  const WireCounters& counters = whole.counters();
  require(counters.received + counters.doubled + counters.implausible <= counters.parser.frames,
          "no more comes out than went in");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  follow(Script(data, size), Framing::stream);
  follow(Script(data, size), Framing::datagrams);
  return 0;
}
