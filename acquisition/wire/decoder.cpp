#include "acquisition/wire/decoder.h"

#include <algorithm>

#include "acquisition/wire/plausible.h"
#include "acquisition/wire/to_message.h"

namespace searig::acquisition {
namespace {

constexpr std::size_t kBootsKept = 32;

std::size_t index_of(wire::Type type) {
  return static_cast<std::size_t>(type) - 1;
}

bool is_sample(wire::Type type) {
  return type == wire::Type::loadcell_sample || type == wire::Type::module_sample;
}

}  // namespace

Decoder::Decoder(Framing framing) : framing_(framing) {
  if (framing == Framing::datagrams) parser_.end();
}

void Decoder::push(std::span<const std::uint8_t> bytes, double host_s,
                   std::vector<Message>& messages) {
  frames_.clear();
  parser_.push(bytes, host_s, frames_);
  if (framing_ == Framing::datagrams) parser_.end();
  counters_.parser = parser_.counters();
  for (const Frame& frame : frames_) take(frame, messages);
}

void Decoder::gap() {
  if (framing_ == Framing::stream) parser_.gap();
  counters_.parser = parser_.counters();
  after_gap_ = true;
  for (Sequence& sequence : sequences_) sequence.after_gap = true;
}

void Decoder::take(const Frame& frame, std::vector<Message>& messages) {
  if (running_ && follows(frame)) {
    if (waiting_) ++counters_.implausible;
    waiting_.reset();
    hand_on(frame, messages);
  } else if (running_ && !may_be_another() && seen(frame)) {
    ++counters_.doubled;
  } else {
    wait_or_begin(frame, messages);
  }
}

/// Whether the frame goes on from the run.
bool Decoder::follows(const Frame& frame) const {
  const wire::Header& header = frame.header;
  if (header.boot != boot_) return false;
  const double device_s =
      static_cast<double>(time_.at(header.time_us, frame.host_s) - time_.us()) * 1e-6;
  if (!keep_time(device_s, frame.host_s - time_.host_s())) return false;
  const Sequence& sequence = sequences_[index_of(header.type)];
  if (!sequence.begun) return true;
  const auto place = sequence.window.place(header.sequence);
  if (place == SequenceWindow::Place::late) return true;
  return place == SequenceWindow::Place::newest &&
         can_skip(sequence.window.skipped(header.sequence), device_s);
}

/// Whether the device stood still since the run's last frame: its next frame, its clock a little
/// further, while the host's went on.
bool Decoder::goes_on_after_pause(const Frame& frame) const {
  const wire::Header& header = frame.header;
  const Sequence& sequence = sequences_[index_of(header.type)];
  if (!running_ || header.boot != boot_ || !sequence.begun) return false;
  if (sequence.window.place(header.sequence) != SequenceWindow::Place::newest) return false;
  const double device_s = (header.time_us - static_cast<std::uint32_t>(time_.us())) * 1e-6;
  return device_s <= frame.host_s - time_.host_s() &&
         can_skip(sequence.window.skipped(header.sequence), device_s);
}

/// Whether the frame came before: in this run, or in one that is over.
bool Decoder::seen(const Frame& frame) const {
  const wire::Header& header = frame.header;
  if (header.boot != boot_) {
    return std::find(earlier_boots_.begin(), earlier_boots_.end(), header.boot) !=
           earlier_boots_.end();
  }
  const Sequence& sequence = sequences_[index_of(header.type)];
  return sequence.begun && header.sequence < sequence.window.next();
}

void Decoder::wait_or_begin(const Frame& frame, std::vector<Message>& messages) {
  if (waiting_ && waiting_->header.boot == frame.header.boot &&
      waiting_->header.type == frame.header.type &&
      waiting_->header.sequence == frame.header.sequence) {
    ++counters_.doubled;
  } else if (waiting_ && go_together(*waiting_, frame)) {
    begin_run(*waiting_, goes_on_after_pause(*waiting_) && goes_on_after_pause(frame), messages);
    hand_on(*waiting_, messages);
    waiting_.reset();
    hand_on(frame, messages);
  } else {
    if (waiting_) ++counters_.implausible;
    waiting_ = frame;
  }
}

void Decoder::begin_run(const Frame& frame, bool paused, std::vector<Message>& messages) {
  const bool from_start = running_ && !after_gap_;  // we were there when the device restarted
  if (running_) {
    ++run_;
    ++(paused ? counters_.pauses : counters_.restarts);
    if (boot_ != frame.header.boot) earlier_boots_.push_back(boot_);
    if (earlier_boots_.size() > kBootsKept) earlier_boots_.pop_front();
    messages.emplace_back(Restart{frame.host_s, run_, frame.header.boot, paused});
  }
  boot_ = frame.header.boot;
  time_.begin(frame.header.time_us, frame.host_s);
  if (paused) return;
  for (Sequence& sequence : sequences_) {
    sequence.begun = from_start;
    if (from_start) sequence.window.begin(0);
  }
  overruns_.reset();
  running_ = true;
}

void Decoder::hand_on(const Frame& frame, std::vector<Message>& messages) {
  count_place(frame);
  const std::int64_t us = time_.at(frame.header.time_us, frame.host_s);
  const Stamp at{frame.host_s, static_cast<double>(us) * 1e-6, frame.header.sequence, run_};
  messages.push_back(to_message(frame, at, time_));
  count_content(messages.back());
  time_.follow(us, frame.host_s);
  after_gap_ = false;
}

void Decoder::count_place(const Frame& frame) {
  const std::uint32_t number = frame.header.sequence;
  Sequence& sequence = sequences_[index_of(frame.header.type)];
  // Of a run that we joined midway, or whose start is far, the first frame seen is the first.
  if (!sequence.begun || (sequence.window.next() == 0 && number > kFewLost)) {
    sequence.window.begin(number);
    sequence.begun = true;
  }
  const bool sample = is_sample(frame.header.type);
  if (sequence.window.place(number) == SequenceWindow::Place::late) {
    ++counters_.out_of_order;
    --counters_.lost;
    if (sample) --counters_.lost_samples;
  } else {
    const std::uint32_t skipped = sequence.window.skipped(number);
    counters_.lost += skipped;
    if (sample) counters_.lost_samples += skipped;
    if (sequence.after_gap) counters_.lost_in_gaps += skipped;
  }
  sequence.window.mark(number);
  sequence.after_gap = false;
  ++counters_.received;
  if (sample) ++counters_.samples;
}

void Decoder::count_content(const Message& message) {
  std::optional<std::uint16_t> overruns;
  if (const auto* sample = std::get_if<LoadcellSample>(&message)) {
    counters_.repeated += sample->repeated;
    counters_.at_limit += sample->at_limit;
    overruns = sample->overruns;
  } else if (const auto* other = std::get_if<ModuleSample>(&message)) {
    overruns = other->overruns;
  }
  if (!overruns) return;
  // The device counts in 16 bits; a late frame counts backwards and is left alone.
  const auto more = static_cast<std::uint16_t>(*overruns - overruns_.value_or(*overruns));
  if (more >= 0x8000) return;
  counters_.device_overruns += more;
  overruns_ = overruns;
}

}  // namespace searig::acquisition
