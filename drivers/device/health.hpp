#pragma once

#include <cstdint>
#include <optional>

#include "drivers/device/life_cycle.hpp"
#include "drivers/device/rate_meter.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::device {

/// What a program that watches a device needs to know several times a second: no words are made for
/// it.
struct Vitals {
  State state = State::closed;
  Stamp since{};                  ///< start of the present state
  wire::StreamCounters stream;    ///< this device's frames; on a bus only those it understands
  std::uint64_t held_bytes = 0;   ///< waiting for the rest of a frame
  std::optional<double> rate_hz;  ///< rate of its fastest kind of measurement, while streaming
  std::optional<Stamp> last_message_at;
  Reason last_error;                                      ///< empty: none so far
  std::uint32_t reopened = 0;                             ///< how often the link was opened again
  std::optional<Stamp> link_up_since, link_broken_since;  ///< as LifeCycle says
  std::uint32_t link_failures = 0;  ///< how often it could not be opened or broke off
  std::uint64_t bytes_not_text =
      0;                           ///< of those on a line, all of them: neither printed nor an end
  std::uint64_t error_frames = 0;  ///< from the CAN controller
  std::uint64_t impossible = 0;    ///< among the refused ones
};

/// What a person needs to know about one device. It is a plain value that can be copied at any
/// time.
struct Health : Vitals {
  Reason status;                 ///< the present state in words
  std::uint64_t messages = 0;    ///< number of published measurements
  std::optional<Jitter> jitter;  ///< of the intervals of the fastest kind
  double nominal_rate_hz = 0;
  std::optional<std::chrono::nanoseconds> age;  ///< of the last message, at the time of the call
  std::optional<std::chrono::nanoseconds> last_error_age;  ///< at the time of the call
  std::uint64_t errors = 0;       ///< how many so far, the last one among them
  Reason link_note;               ///< of the link, for a person; empty: none
  std::uint64_t can_dropped = 0;  ///< frames that the kernel lost on this bus
  std::uint64_t refused = 0;      ///< values that were not published
  Reason left_out;                ///< why, of the last good one; it is no error. Empty: none
};

}  // namespace drydock::device
