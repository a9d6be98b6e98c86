#pragma once

#include <cstdint>
#include <vector>

#include "drivers/measurement/message_time.hpp"

namespace drydock::device {

/// Where the messages of one device in a recording end: bytes or frames, rising.
using Places = std::vector<std::uint64_t>;

/// The clock that one device tells in a recording, for all devices in it. What stands between two
/// messages of the clock comes with the second one, as a burst. A device that says more than a
/// burst between them is faster than the clock: its messages come at even distances. Behind the
/// last message of the clock time goes on at the mean rate of its places. The clock must not be
/// empty.
measurement::MessageTimes times_at(const measurement::MessageTimes& clock,
                                   const std::vector<Places>& devices);

}  // namespace drydock::device
