#include "drivers/capture/stream_order.hpp"

#include <algorithm>

namespace drydock::capture {

void StreamOrder::begin(std::uint32_t sequence) {
  finish();
  next_ = (std::uint64_t{1} << 32) + sequence + 1;
}

void StreamOrder::take(std::uint32_t sequence, wire::Bytes payload) {
  if (payload.empty()) return;
  if (!next_) next_ = (std::uint64_t{1} << 32) + sequence;
  // Numbers have 32 bits: the place is the one nearest to the awaited byte.
  const auto ahead = static_cast<std::int32_t>(sequence - static_cast<std::uint32_t>(*next_));
  const std::uint64_t first = *next_ + static_cast<std::uint64_t>(std::int64_t{ahead});
  auto& held = waiting_[first];
  if (held.size() >= payload.size()) return;
  waiting_bytes_ += payload.size() - held.size();
  held.assign(payload.begin(), payload.end());
  move_on();
  while (waiting_bytes_ > most_waiting) {
    lost_ += waiting_.begin()->first - *next_;
    next_ = waiting_.begin()->first;
    move_on();
  }
}

/// Everything up to the first gap.
void StreamOrder::move_on() {
  while (!waiting_.empty() && waiting_.begin()->first <= *next_) {
    const auto& [first, bytes] = *waiting_.begin();
    const std::uint64_t known = *next_ - first;
    if (known < bytes.size()) {
      ready_.insert(ready_.end(), bytes.begin() + static_cast<std::ptrdiff_t>(known), bytes.end());
      next_ = first + bytes.size();
    }
    waiting_bytes_ -= bytes.size();
    waiting_.erase(waiting_.begin());
  }
}

wire::Bytes StreamOrder::ready() {
  given_.swap(ready_);
  ready_.clear();
  return given_;
}

void StreamOrder::finish() {
  while (!waiting_.empty()) {
    lost_ += waiting_.begin()->first - *next_;
    next_ = waiting_.begin()->first;
    move_on();
  }
}

}  // namespace drydock::capture
