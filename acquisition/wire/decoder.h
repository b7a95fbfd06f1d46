// Bytes of one device -> its messages. Pure: no input, no output, no clock of its own, so that
// live, replayed and batch decoding of the same arrivals are bit-identical.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "acquisition/wire/frame_parser.h"
#include "acquisition/wire/messages.h"
#include "acquisition/wire/sequence_window.h"
#include "acquisition/wire/unwrapped_time.h"

namespace searig::acquisition {

/// What became of the frames.
struct WireCounters {
  ParserCounters parser;              ///< what the bytes were
  std::uint64_t received = 0;         ///< messages handed on, without Restart
  std::uint64_t samples = 0;          ///< of them samples
  std::uint64_t lost = 0;             ///< missing in the sequences; a late one is no longer lost
  std::uint64_t lost_samples = 0;     ///< of them samples
  std::uint64_t lost_in_gaps = 0;     ///< of the lost: while the line was cut
  std::uint64_t doubled = 0;          ///< seen before, too old to tell, or of an earlier start
  std::uint64_t out_of_order = 0;     ///< sent before one that came before them; handed on
  std::uint64_t implausible = 0;      ///< good, but at a place or time that cannot be; left out
  std::uint64_t restarts = 0;         ///< of the device while we listened
  std::uint64_t pauses = 0;           ///< its clock stood still; frames went on where they were
  std::uint64_t repeated = 0;         ///< load-cell samples without a new reading
  std::uint64_t at_limit = 0;         ///< load-cell samples at an end of the converter's range
  std::uint64_t device_overruns = 0;  ///< what the device could not make or send
};

/// Whether frames may be spread over arrivals, or each arrival holds whole frames.
enum class Framing : std::uint8_t { stream, datagrams };

/// A frame is taken where boot, sequence and time go on from those before it. Where they do not, it
/// waits for the next: if the two go together the device has restarted (or another is there, if the
/// line was cut), and both are taken; else the first was implausible. So a damaged frame that
/// passes its CRC changes nothing.
class Decoder {
 public:
  explicit Decoder(Framing framing = Framing::stream);

  /// Appends the messages that these bytes complete. host_s: their arrival; must not fall.
  void push(std::span<const std::uint8_t> bytes, double host_s, std::vector<Message>& messages);

  /// The line was cut (Arrival::Kind::unplugged): what was begun does not go on, and the device may
  /// have restarted, or be another.
  void gap();

  const WireCounters& counters() const { return counters_; }

 private:
  static constexpr std::size_t kTypes = 4;  ///< that devices send: 1 to 4

  void take(const Frame& frame, std::vector<Message>& messages);
  /// Behind a cut cable there may be another device, whose numbers mean nothing here.
  bool may_be_another() const { return after_gap_ && framing_ == Framing::stream; }
  bool seen(const Frame& frame) const;
  bool follows(const Frame& frame) const;
  bool goes_on_after_pause(const Frame& frame) const;
  void wait_or_begin(const Frame& frame, std::vector<Message>& messages);
  void begin_run(const Frame& frame, bool paused, std::vector<Message>& messages);
  void hand_on(const Frame& frame, std::vector<Message>& messages);
  void count_place(const Frame& frame);
  void count_content(const Message& message);

  Framing framing_;
  FrameParser parser_;
  std::vector<Frame> frames_;     ///< kept for its memory only
  std::optional<Frame> waiting_;  ///< did not follow; see above

  bool running_ = false;    ///< whether there is a run to follow
  bool after_gap_ = false;  ///< and the line was cut since its last frame
  std::uint16_t boot_ = 0;
  std::uint32_t run_ = 0;
  std::deque<std::uint16_t> earlier_boots_;
  UnwrappedTime time_;
  std::optional<std::uint16_t> overruns_;

  struct Sequence {
    SequenceWindow window;
    bool begun = false;      ///< whether it is known which number comes next
    bool after_gap = false;  ///< the line was cut since the last of this type
  };
  std::array<Sequence, kTypes> sequences_;
  WireCounters counters_;
};

}  // namespace searig::acquisition
