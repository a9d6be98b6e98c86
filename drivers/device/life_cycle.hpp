#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/device/fixed_text.hpp"
#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

using measurement::Stamp;

///   closed --start--> opening --opened--> waiting --message--> streaming <--message-- stale
///                        ^  \                \                      \--quiet--------->/
///                        |   +--failed--------+--lost, quiet---------+--lost, quiet--+
///                        +-------- backing_off <-------------------------------------+
enum class State : std::uint8_t { closed, opening, waiting, streaming, stale, backing_off };

constexpr std::string_view to_string(State state) {
  constexpr std::array<std::string_view, 6> names{"closed",    "opening", "waiting",
                                                  "streaming", "stale",   "backing off"};
  return names[static_cast<std::size_t>(state)];
}

struct LifeCycleOptions {
  std::chrono::nanoseconds stale_after = std::chrono::seconds{2};    ///< streaming -> stale
  std::chrono::nanoseconds reopen_after = std::chrono::seconds{10};  ///< waiting, stale -> again
  /// A serial line that went quiet may need opening again. A bus is shared, and a device that says
  /// nothing on it is no fault of the bus: false keeps it open.
  bool reopen_when_quiet = true;
  std::string_view quiet_but_up = " on a bus that is up";  ///< said of silence on what stays open
  std::chrono::nanoseconds first_back_off = std::chrono::milliseconds{250};  ///< doubles each time
  /// To ask for a port that is away costs next to nothing: one that is back is found at once.
  std::chrono::nanoseconds back_off_cap = std::chrono::seconds{1};
  /// A line whose rate is searched: that it is opened again, at the next rate, is no change of
  /// state.
  bool reopen_in_place = false;
};

/// One change of state, in words: what happened and what happens next.
struct Transition {
  State from = State::closed;
  State to = State::closed;
  Stamp at{};
  Reason why;
};

/// When a device is opened, believed, doubted and given up. It is told what happened and asked what
/// to do; it never touches a link. Every event answers with the change of state it made, if any.
class LifeCycle {
 public:
  using Change = std::optional<Transition>;

  explicit LifeCycle(const LifeCycleOptions& options = {}) : options_(options) {}

  Change start(Stamp now);
  Change opened(Stamp now);
  Change open_failed(Stamp now, std::string_view reason);
  Change message(Stamp now);
  Change link_lost(Stamp now, std::string_view reason);
  Change stop(Stamp now, std::string_view reason = "stopped");
  Change tick(Stamp now);  ///< at or after deadline()
  /// The clock that gives the stamps was set: what has lasted so long goes on lasting.
  void clock_stepped(std::chrono::nanoseconds step);

  State state() const { return state_; }
  Stamp since() const { return since_; }
  bool wants_open() const { return state_ == State::opening || (reopening_ && !link_open_); }
  /// The link is open and should not be. Closing it is told by link_lost().
  bool wants_close() const { return link_open_ && (reopening_ || !uses_link()); }
  std::optional<Stamp> deadline() const;
  std::uint32_t opened_count() const { return opened_count_; }
  Reason status(Stamp now) const;  ///< the present state in words
  bool uses_link() const {
    return state_ == State::waiting || state_ == State::streaming || state_ == State::stale;
  }

 private:
  Change enter(State to, Stamp now, std::string_view why);
  Change back_off(Stamp now, std::string_view reason);
  Reason silence(Stamp now) const;

  LifeCycleOptions options_;
  State state_ = State::closed;
  Stamp since_{};
  Stamp last_message_{};
  Reason why_;
  bool link_open_ = false;
  bool reopening_ = false;  ///< in place, and not open yet
  Stamp listens_since_{};   ///< of a line that is opened again in place
  std::uint32_t opened_count_ = 0;
  std::chrono::nanoseconds next_back_off_{0};  ///< zero: the first
  std::chrono::nanoseconds waits_{0};          ///< of the back-off under way
};

inline std::optional<Stamp> LifeCycle::deadline() const {
  switch (state_) {
    case State::closed:
    case State::opening: return {};
    case State::streaming: return last_message_ + options_.stale_after;
    case State::backing_off: return since_ + waits_;
    case State::waiting:
    case State::stale:
      if (!options_.reopen_when_quiet || reopening_) return {};
      return std::max(since_, listens_since_) + options_.reopen_after;
  }
  return {};
}

}  // namespace drydock::device
