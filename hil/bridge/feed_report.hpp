#pragma once

#include <string>

#include "hil/bridge/autopilot_feed.hpp"

/// The figures at the end of a bridge's run.
namespace drydock::bridge {

/// Lines, each with its end.
std::string to_text(const FeedCounters& counters);

/// One object on one line, keys with their unit.
std::string to_json(const FeedCounters& counters);

/// What an autopilot should take as the delay of the motion (ArduPilot: VISO_DELAY_MS): the mean
/// age of the pings that were sent and half of the mean interval, because a mean velocity is that
/// of the middle.
std::chrono::nanoseconds delay_of(const FeedCounters& counters);

}  // namespace drydock::bridge
