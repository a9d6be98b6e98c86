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
  std::chrono::nanoseconds reopen_after = std::chrono::seconds{10};  ///< waiting, stale: open again
  /// A serial line that went quiet may need opening again. A bus is shared, and a silent device is
  /// no fault of the bus: false keeps it open.
  bool reopen_when_quiet = true;
  std::string_view quiet_but_up = " on a bus that is up";  ///< for silence on an open link
  std::chrono::nanoseconds first_back_off = std::chrono::milliseconds{250};  ///< doubles each time
  /// It costs almost nothing to try a port that is missing. With a short limit a port that is back
  /// is found at once.
  std::chrono::nanoseconds back_off_cap = std::chrono::seconds{1};
  /// For a line whose rate is searched: opening it again at the next rate is no change of state.
  bool reopen_in_place = false;
};

/// One change of state, in words: what happened and what comes next.
struct Transition {
  State from = State::closed;
  State to = State::closed;
  Stamp at{};
  Reason why;
};

/// Decides when a device is opened, believed, doubted and given up. It receives events and answers
/// questions; it never touches a link. Every event returns the change of state that it made, if
/// any.
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
  /// Other devices use the link too: the silence of one does not open it again.
  void share_link() { shares_link_ = true; }
  /// When its silence is long enough to open the link again. Empty: it is heard, or never.
  std::optional<Stamp> gives_up_at() const;
  Change give_up(Stamp now);  ///< for a shared link, at or after gives_up_at() of all on it
  /// Nothing more comes: the next silence is the end of the recording, not a fault.
  void end_of_recording() { recording_ended_ = true; }
  /// The clock that gives the stamps was changed. Durations go on as if it had not been.
  void clock_stepped(std::chrono::nanoseconds step);

  State state() const { return state_; }
  Stamp since() const { return since_; }
  bool wants_open() const { return state_ == State::opening || (reopening_ && !link_open_); }
  /// The link is open and should not be. Report with link_lost() that it is closed.
  bool wants_close() const { return link_open_ && (reopening_ || !uses_link()); }
  std::optional<Stamp> deadline() const;
  std::uint32_t opened_count() const { return opened_count_; }
  /// A message could have come since then. Opening the link again because nothing comes changes
  /// nothing. Empty: the link is broken or closed.
  std::optional<Stamp> link_up_since() const { return link_up_since_; }
  /// The link could not be opened, or broke off. Empty: it is there, or it was closed on purpose.
  std::optional<Stamp> link_broken_since() const { return link_broken_since_; }
  std::uint32_t link_failures() const { return link_failures_; }
  Reason status(Stamp now) const;  ///< the present state in words
  bool uses_link() const {
    return state_ == State::waiting || state_ == State::streaming || state_ == State::stale;
  }

 private:
  Change enter(State to, Stamp now, std::string_view why);
  Change back_off(Stamp now, std::string_view reason);
  void note_broken_link(Stamp now);
  Reason silence(Stamp now) const;

  LifeCycleOptions options_;
  State state_ = State::closed;
  Stamp since_{};
  Stamp last_message_{};
  Reason why_;
  bool link_open_ = false;
  bool reopening_ = false;  ///< in place, and not yet open
  bool shares_link_ = false, recording_ended_ = false;
  Stamp listens_since_{};  ///< for a line that is opened again in place
  std::uint32_t opened_count_ = 0, link_failures_ = 0;
  std::optional<Stamp> link_up_since_, link_broken_since_;
  std::chrono::nanoseconds next_back_off_{0};  ///< zero: the first back-off
  std::chrono::nanoseconds waits_{0};          ///< length of the current back-off
};

inline std::optional<Stamp> LifeCycle::deadline() const {
  switch (state_) {
    case State::closed:
    case State::opening: return {};
    case State::streaming: return last_message_ + options_.stale_after;
    case State::backing_off: return since_ + waits_;
    case State::waiting:
    case State::stale: return shares_link_ ? std::nullopt : gives_up_at();
  }
  return {};
}

inline std::optional<Stamp> LifeCycle::gives_up_at() const {
  if (state_ != State::waiting && state_ != State::stale) return {};
  if (!options_.reopen_when_quiet || reopening_) return {};
  return std::max(since_, listens_since_) + options_.reopen_after;
}

}  // namespace drydock::device
