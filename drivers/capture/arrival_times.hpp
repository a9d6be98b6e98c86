#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "drivers/capture/capture_file.hpp"
#include "drivers/capture/record.hpp"

namespace drydock::capture {

/// Judges whether a CAN capture keeps when its frames arrived. Some programs write no times, others
/// the time at which they printed a whole buffer: then frames come faster than any bus carries
/// them. Add the capture's frames in order; the first thousand are enough.
class ArrivalTimes {
 public:
  void add(const Record& record);
  bool enough() const { return frames_ >= most_frames; }
  /// False too if a frame had no time. A few frames in one instant may be one long message.
  bool are_told() const;
  std::optional<std::chrono::nanoseconds> first() const { return first_; }

 private:
  static constexpr std::uint64_t most_frames = 1000;

  std::uint64_t frames_ = 0, bits_ = 0;
  bool missing_ = false;
  std::optional<std::chrono::nanoseconds> first_;
  std::chrono::nanoseconds earliest_{}, latest_{};
};

/// Of the frames that the file has next; it reads no more than are enough.
ArrivalTimes arrival_times_of(CaptureFile& file);

}  // namespace drydock::capture
