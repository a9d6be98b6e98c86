#include "drivers/capture/arrival_times.hpp"

#include <algorithm>

#include "drivers/wire/can/can_bits.hpp"

namespace drydock::capture {

void ArrivalTimes::add(const Record& record) {
  ++frames_;
  if (!record.time) {
    missing_ = true;
    return;
  }
  if (!first_) first_ = earliest_ = latest_ = *record.time;
  earliest_ = std::min(earliest_, *record.time);
  latest_ = std::max(latest_, *record.time);
  if (!record.frame.fd) bits_ += wire::wire_bits(record.frame);
}

bool ArrivalTimes::are_told() const {
  constexpr std::uint64_t few_frames = 100;
  // Four buses at 1 Mbit/s, the fastest classic CAN, in one capture.
  constexpr std::chrono::nanoseconds shortest_bit{250};
  if (missing_ || frames_ == 0) return false;
  if (frames_ < few_frames) return true;
  return latest_ - earliest_ >= shortest_bit * static_cast<std::int64_t>(bits_);
}

ArrivalTimes arrival_times_of(CaptureFile& file) {
  ArrivalTimes arrivals;
  while (!arrivals.enough()) {
    const auto record = file.next();
    if (!record) break;
    arrivals.add(*record);
  }
  return arrivals;
}

}  // namespace drydock::capture
