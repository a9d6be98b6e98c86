#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/measurement/stamp.hpp"
#include "drivers/wire/can/can_frame.hpp"
#include "hil/emulate/emulated_device.hpp"

namespace drydock::emulate {

/// A bus shared by its nodes. It carries one frame at a time, in the order of sending.
class CanPacer {
 public:
  static constexpr std::size_t bound = 256;  ///< frames that may wait; beyond that the oldest is
                                             ///< lost

  explicit CanPacer(unsigned bit_rate) : bit_rate_(bit_rate) {}

  struct Sent {
    wire::CanFrame frame;
    Stamp at{};      ///< end of the frame before the intermission; controllers stamp this time
    int sender = 0;  ///< as given to queue()
    Passage passage;
  };

  void queue(const wire::CanFrame& frame, int sender, Stamp now,
             std::optional<Stamp> sampled_at = {});
  std::optional<Stamp> deadline() const;
  std::optional<Sent> take(Stamp now);

  std::uint64_t frames_lost() const { return frames_lost_; }

 private:
  struct Waiting {
    wire::CanFrame frame;
    int sender = 0;
    Stamp queued_at{};
    std::optional<Stamp> sampled_at;
  };

  void begin_first();
  std::chrono::nanoseconds line_time(unsigned bits) const;

  unsigned bit_rate_;
  std::vector<Waiting> waiting_;  ///< the first one is on the wire
  Stamp first_begins_{}, first_ends_{};
  Stamp free_at_{};  ///< end of the previous frame's intermission
  std::uint64_t frames_lost_ = 0;
};

}  // namespace drydock::emulate
