// Pieces of work from one thread to another, a few at most underway.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace searig::app {

template <class Piece>
class HandOver {
 public:
  /// Waits until there is room. False where nobody takes any more.
  bool give(Piece piece) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return pieces_.size() < most || refused_; });
    if (refused_) return false;
    pieces_.push_back(std::move(piece));
    changed_.notify_all();
    return true;
  }

  /// The giver is done; by an exception, if there is one.
  void end(std::exception_ptr error = {}) {
    const std::scoped_lock lock(mutex_);
    ended_ = true, error_ = std::move(error);
    changed_.notify_all();
  }

  /// Waits for the next; nothing after the last. Throws what the giver ended with.
  std::optional<Piece> take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !pieces_.empty() || ended_; });
    if (pieces_.empty()) {
      if (error_) std::rethrow_exception(error_);
      return std::nullopt;
    }
    Piece piece = std::move(pieces_.front());
    pieces_.pop_front();
    changed_.notify_all();
    return piece;
  }

  /// The taker is done, whether or not there are more.
  void refuse() {
    const std::scoped_lock lock(mutex_);
    refused_ = true;
    changed_.notify_all();
  }

 private:
  static constexpr std::size_t most = 4;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Piece> pieces_;
  bool ended_ = false, refused_ = false;
  std::exception_ptr error_;
};

/// make(give) runs in a thread of its own, by a few pieces ahead of take(piece), which runs in the
/// caller's. What either of them throws ends both and comes out here.
template <class Piece, class Make, class Take>
void make_ahead(Make make, Take take) {
  struct Refused {};
  HandOver<Piece> pieces;
  const std::jthread maker([&] {
    try {
      make([&](Piece piece) {
        if (!pieces.give(std::move(piece))) throw Refused();
      });
      pieces.end();
    } catch (const Refused&) {
    } catch (...) {
      pieces.end(std::current_exception());
    }
  });
  // Lets the maker go before it is waited for.
  struct AtTheEnd {
    HandOver<Piece>& pieces;
    ~AtTheEnd() { pieces.refuse(); }
  } const at_the_end{pieces};
  while (auto piece = pieces.take()) take(std::move(*piece));
}

}  // namespace searig::app
