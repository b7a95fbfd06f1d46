// Where bytes come from: a serial line, a datagram socket. A recorder pulls from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace searig::acquisition {

/// Seconds of the host's monotonic clock, the one that stamps every arrival.
double host_now_s();

/// What came from a source, in its order: raw bytes, or something that befell it.
struct Arrival {
  enum class Kind : std::uint8_t {
    bytes,        ///< as read; frames may begin and end anywhere (a datagram is one arrival)
    connected,    ///< opened for the first time
    unplugged,    ///< the device or its line is gone; bytes before and after do not join
    reconnected,  ///< opened again
    unusable      ///< cannot be opened now (absent, busy, not allowed); tried on; said once
  };
  Kind kind = Kind::bytes;
  double host_s = 0.0;              ///< host_now_s() when it was read or noticed
  std::vector<std::uint8_t> bytes;  ///< of Kind::bytes only
  std::string what;                 ///< of the others: one sentence for people
};

/// The word for an event as it stands in a recording: "unplugged".
std::string_view name_of(Arrival::Kind kind);

struct SourceCounters {
  std::uint64_t bytes = 0;     ///< handed on
  std::uint64_t stale = 0;     ///< bytes thrown away at opening: they were there before
  std::uint64_t foreign = 0;   ///< datagrams from another sender than the device
  std::uint64_t too_long = 0;  ///< datagrams longer than any frame
  std::uint64_t unplugged = 0;
  std::uint64_t reconnected = 0;
  std::uint64_t unsent = 0;  ///< bytes given to send() that did not go out
};

class Source {
 public:
  virtual ~Source() = default;

  /// The name that it was opened by, for people and for the recording: "serial:/dev/ttyACM0".
  virtual std::string name() const = 0;

  /// Of the line on which each byte takes its time; 0 where bytes come in pieces.
  virtual unsigned baud() const { return 0; }

  /// To be polled for input, or -1 while there is none (unplugged).
  virtual int handle() const = 0;

  /// When read() wants to be called although the handle is silent (to look for an unplugged
  /// device), as host_now_s(); infinity where never.
  virtual double wake_s() const = 0;

  /// Appends everything there is by now and returns; never waits. What cannot be mended comes as
  /// an event, not as an exception.
  virtual void read(std::vector<Arrival>& arrivals) = 0;

  /// Sends bytes to the device (pings) without waiting; what the line does not take is counted.
  virtual void send(std::span<const std::uint8_t> bytes) = 0;

  virtual const SourceCounters& counters() const = 0;
};

/// Sleeps until a source has something to read(), wants to be called, or timeout_s has passed.
/// Burns no time of the processor meanwhile.
void wait_for(std::span<Source* const> sources, double timeout_s);

/// Opens by name: serial:DEVICE[@BAUD] or udp:HOST:PORT, both also with "//" behind the colon; a
/// plain path is a serial device. A serial device that is not there yet is waited for, and said as
/// an event; a name that makes no sense, or a port in use by another program, throws InputError.
std::unique_ptr<Source> open_source(std::string_view name);

}  // namespace searig::acquisition
