#include "drivers/device/life_cycle.hpp"

#include <algorithm>

#include "drivers/device/duration_text.hpp"

namespace drydock::device {

namespace {
constexpr std::string_view rate_is_searched = "; its rate is searched";
}

LifeCycle::Change LifeCycle::enter(State to, Stamp now, std::string_view why) {
  const Transition change{state_, to, now, why};
  state_ = to;
  since_ = now;
  reopening_ = false;
  if (to == State::closed) {
    link_up_since_.reset();
    link_broken_since_.reset();
  }
  why_ = change.why;
  return change;
}

LifeCycle::Change LifeCycle::back_off(Stamp now, std::string_view reason) {
  waits_ = next_back_off_.count() == 0 ? options_.first_back_off : next_back_off_;
  next_back_off_ = std::min(waits_ * 2, options_.back_off_cap);
  constexpr std::size_t room_for_next_step = 24;
  Reason why{reason.substr(0, Reason::capacity - room_for_next_step)};
  why += "; retry in ";
  why += in_words(waits_).view();
  return enter(State::backing_off, now, why.view());
}

void LifeCycle::note_broken_link(Stamp now) {
  link_up_since_.reset();
  if (!link_broken_since_) link_broken_since_ = now;
  ++link_failures_;
}

LifeCycle::Change LifeCycle::start(Stamp now) {
  if (state_ != State::closed) return {};
  next_back_off_ = {};
  return enter(State::opening, now, "started; opening the link");
}

LifeCycle::Change LifeCycle::opened(Stamp now) {
  link_open_ = true;
  listens_since_ = now;
  if (!link_up_since_ && state_ != State::closed) link_up_since_ = now;
  link_broken_since_.reset();
  if (reopening_) {
    reopening_ = false;
    ++opened_count_;
    return {};
  }
  // A shared bus may open before this device's own back-off ends. In state closed the device was
  // stopped in the meantime, and wants_close() is true.
  if (state_ != State::opening && state_ != State::backing_off) return {};
  ++opened_count_;
  return enter(State::waiting, now,
               options_.reopen_in_place ? "link open; its rate is searched until the first message"
                                        : "link open; waiting for the first message");
}

LifeCycle::Change LifeCycle::open_failed(Stamp now, std::string_view reason) {
  if (!wants_open()) return {};
  note_broken_link(now);
  return back_off(now, reason);
}

LifeCycle::Change LifeCycle::message(Stamp now) {
  if (!uses_link()) return {};
  last_message_ = now;
  if (state_ == State::streaming) return {};
  next_back_off_ = {};
  return enter(State::streaming, now,
               state_ == State::waiting ? "first message" : "messages have come back");
}

LifeCycle::Change LifeCycle::link_lost(Stamp now, std::string_view reason) {
  link_open_ = false;
  if (!uses_link() || reopening_) return {};
  note_broken_link(now);
  return back_off(now, reason);
}

LifeCycle::Change LifeCycle::stop(Stamp now, std::string_view reason) {
  if (state_ == State::closed) return {};
  return enter(State::closed, now, reason);
}

void LifeCycle::clock_stepped(std::chrono::nanoseconds step) {
  since_ += step;
  last_message_ += step;
  listens_since_ += step;
  if (link_up_since_) *link_up_since_ += step;
  if (link_broken_since_) *link_broken_since_ += step;
}

Reason LifeCycle::silence(Stamp now) const {
  Reason text{"no message for "};
  text += in_words(now - (state_ == State::waiting ? since_ : last_message_)).view();
  return text;
}

Reason LifeCycle::status(Stamp now) const {
  if (state_ != State::waiting && state_ != State::stale) return why_;
  Reason text = silence(now);
  if (options_.reopen_in_place) text += rate_is_searched;
  if (!options_.reopen_when_quiet) text += options_.quiet_but_up;
  return text;
}

LifeCycle::Change LifeCycle::tick(Stamp now) {
  const auto due = deadline();
  if (!due || now < *due) return {};
  if (state_ == State::backing_off) return enter(State::opening, now, "opening the link again");

  if (state_ != State::streaming) return give_up(now);
  if (recording_ended_) return enter(State::closed, now, "end of the recording");

  Reason why = silence(now);
  if (options_.reopen_in_place) {
    why += rate_is_searched;
  } else if (options_.reopen_when_quiet && shares_link_) {
    why += "; the link is opened again when all devices on it are quiet for ";
    why += in_words(options_.reopen_after).view();
  } else if (options_.reopen_when_quiet) {
    why += "; opening the link again in ";
    why += in_words(options_.reopen_after).view();
    why += " if it stays quiet";
  } else {
    why += options_.quiet_but_up;
    why += "; waiting for the next";
  }
  return enter(State::stale, now, why.view());
}

LifeCycle::Change LifeCycle::give_up(Stamp now) {
  if (!options_.reopen_in_place) return back_off(now, silence(now).view());
  reopening_ = true;
  return {};
}

}  // namespace drydock::device
