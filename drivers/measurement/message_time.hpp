#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

namespace drydock::measurement {

/// When one message of a recording was sent, by the device's own clock.
struct MessageTime {
  std::uint64_t through = 0;      ///< bytes of the recording up to its end; on a CAN bus frames
  std::chrono::nanoseconds at{};  ///< on the device's clock
  std::uint64_t bytes = 0;        ///< the last of `through` that the line carried from `at` on
};

/// In the order of the recording: `through` rises, `at` never falls.
using MessageTimes = std::vector<MessageTime>;

}  // namespace drydock::measurement
