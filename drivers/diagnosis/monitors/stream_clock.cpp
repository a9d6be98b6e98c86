#include "drivers/diagnosis/monitors/stream_clock.hpp"

#include <cmath>
#include <utility>

namespace drydock::diagnosis {
namespace {

constexpr int jumps_to_tell = 3;
/// A delay is told for so long; then it is usual.
constexpr std::chrono::seconds usual_after{60};
/// No line carries twelve bytes more in less.
constexpr std::chrono::microseconds least_move{200};

}  // namespace

bool StreamClock::moves(const measurement::Origin& origin) {
  if (!origin.device_time) return true;
  const auto late = origin.received_at.time_since_epoch() - *origin.device_time;
  const auto before = std::exchange(late_, late);
  return before && std::chrono::abs(late - *before) > least_move;
}

/// A clock that drifts needs no raster to be seen. What has added up is no jump, and what comes
/// later step by step has no slope: the first messages of an epoch are not moved.
StreamClock::News StreamClock::add(const measurement::Origin& origin, Step step, double shift_s,
                                   bool moved, bool has_clock) {
  if (!origin.device_time) return {};
  const Stamp at = origin.received_at;
  const auto news = watch_.add(*origin.device_time, at, origin.valid_at);
  // A message that comes again says nothing about the clock.
  if (news.repeated) return {.repeated = true};
  if (has_clock) {
    if (news.backwards || jumps_ > 0 || moved) rate_.interrupt();
    rate_.add(at, *origin.device_time);
    if (rate_.change_ppm()) watch_.follow();
  }
  return judge(news, at, step, shift_s);
}

StreamClock::News StreamClock::judge(const ClockWatch::News& news, Stamp at, Step step,
                                     double shift_s) {
  News found{.backwards = news.backwards};
  const bool shifted = shift_s > 0 && std::abs(news.jump_s) <= shift_s;
  if (shifted) watch_.accept();
  // Held messages that come together are late by less and less: that is no delay that stays.
  const bool was_held = step == Step::crowded && news.jump_s > 0;
  if (news.jump_s == 0 || was_held || shifted) {
    jumps_ = 0;
    late_by_clock_ = false;
    return found;
  }
  if (jumps_++ == 0) {
    jump_since_ = at;
    const bool after_pause = step == Step::missing || step == Step::odd;
    late_by_clock_ = news.jump_s > 0 && (after_pause || news.aged);
  }
  if (jumps_ < jumps_to_tell) return found;
  found.sign = late_by_clock_ && news.jump_s > 0 ? Sign::late : Sign::clock_step;
  found.since = jump_since_;
  found.amount = {news.jump_s, watch_.limit_s(), "arrival against its own time", "s"};
  if (at - jump_since_ > usual_after) watch_.accept();
  return found;
}

}  // namespace drydock::diagnosis
