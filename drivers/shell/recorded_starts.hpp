#pragma once

#include <span>
#include <vector>

#include "drivers/shell/recording_clock.hpp"

namespace drydock::shell {

/// When recordings that play beside each other begin. Those that keep their times of arrival and
/// began within a day of the first one are of one dive: they keep their distances. Others begin at
/// `start`. In the order of `clocks`.
std::vector<Stamp> recorded_starts(std::span<const RecordingClock> clocks, Stamp start);

}  // namespace drydock::shell
