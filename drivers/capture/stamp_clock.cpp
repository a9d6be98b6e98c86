#include "drivers/capture/stamp_clock.hpp"

#include <algorithm>

#include "drivers/capture/words.hpp"

namespace drydock::capture {

void StampClock::take(const std::optional<LoggerTime>& stamp) {
  using std::chrono::nanoseconds;
  constexpr std::chrono::hours day{24};
  if (!stamp) return;
  if (stamp->order != DateOrder::unknown) order_ = stamp->order;
  if (!dated_) dated_ = !stamp->of_day;
  if (*dated_ && stamp->of_day) return;  // a torn stamp
  ++timed_;
  whole_seconds_ = whole_seconds_ && stamp->whole_second;
  if (pauses_) {
    last_ = std::min(last_.value_or(nanoseconds{0}) + stamp->time, latest_time);
    return;
  }
  last_ = steady_.of("", *dated_ ? stamp->time : days_.since_first_midnight(stamp->time % day));
}

}  // namespace drydock::capture
