#pragma once

#include <cstdint>
#include <optional>

#include "drivers/device/life_cycle.hpp"
#include "drivers/device/rate_meter.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::device {

/// What a person needs to know about one device; a plain value, copied out at any time.
struct Health {
  State state = State::closed;
  Stamp since{};                  ///< of the present state
  Reason status;                  ///< the present state in words
  wire::StreamCounters stream;    ///< this device's frames; on a bus only those it understands
  std::uint64_t held_bytes = 0;   ///< waiting for the rest of a frame
  std::uint64_t messages = 0;     ///< measurements published
  std::optional<double> rate_hz;  ///< of its fastest kind of measurement, while streaming
  std::optional<Jitter> jitter;   ///< of that kind's intervals
  double nominal_rate_hz = 0;
  std::optional<Stamp> last_message_at;
  std::optional<std::chrono::nanoseconds> age;  ///< of the last message, at the time of asking
  Reason last_error;                            ///< empty: none so far
  std::uint32_t reopened = 0;                   ///< times the link was opened after the first
  std::uint64_t can_dropped = 0;                ///< frames the kernel lost for this bus
  std::uint64_t error_frames = 0;               ///< of the CAN controller
};

}  // namespace drydock::device
