#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "drivers/measurement/measurement.hpp"

namespace drydock::device {

using measurement::Origin;

/// Messages that follow each other without a pause waited for the line, not for the sensor. Thus
/// all of them were true before the first was sent. A new burst begins after a pause, or when a
/// kind of message repeats.
class Burst {
 public:
  static constexpr std::size_t kinds = 64;

  explicit Burst(std::chrono::nanoseconds shortest_pause) : shortest_pause_(shortest_pause) {}

  /// Takes the origin of a single message that needs `on_wire` to send. Returns it with the burst's
  /// valid_at.
  Origin of(Origin origin, std::chrono::nanoseconds on_wire, std::size_t kind) {
    const std::uint64_t bit = std::uint64_t{1} << kind % kinds;
    const auto pause = origin.received_at - on_wire - ended_at_;
    if (seen_ == 0 || (seen_ & bit) != 0 || pause > shortest_pause_) {
      seen_ = 0;
      valid_at_ = origin.valid_at;
    }
    seen_ |= bit;
    ended_at_ = origin.received_at;
    origin.valid_at = valid_at_;
    return origin;
  }

  /// The same for a further part of a message, which cannot begin a burst by repeating.
  Origin of_part(Origin origin, std::chrono::nanoseconds on_wire) {
    if (origin.received_at - on_wire - ended_at_ > shortest_pause_) valid_at_ = origin.valid_at;
    ended_at_ = origin.received_at;
    origin.valid_at = valid_at_;
    return origin;
  }

  void end() { seen_ = 0; }

 private:
  std::chrono::nanoseconds shortest_pause_;
  std::uint64_t seen_ = 0;  ///< one bit for each kind
  measurement::Stamp ended_at_{}, valid_at_{};
};

}  // namespace drydock::device
