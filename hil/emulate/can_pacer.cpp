#include "hil/emulate/can_pacer.hpp"

#include <algorithm>

#include "drivers/wire/can/can_bits.hpp"

namespace drydock::emulate {
namespace {

constexpr unsigned intermission_bits = 3;

}  // namespace

// Rounds up, so that no frame ends early.
std::chrono::nanoseconds CanPacer::line_time(unsigned bits) const {
  return std::chrono::nanoseconds{(std::uint64_t{bits} * 1'000'000'000 + bit_rate_ - 1) /
                                  bit_rate_};
}

void CanPacer::begin_first() {
  const unsigned bits = wire::classic_bits(waiting_.front().frame);
  first_begins_ = std::max(free_at_, waiting_.front().queued_at);
  first_ends_ = first_begins_ + line_time(bits - intermission_bits);
  free_at_ = first_begins_ + line_time(bits);
}

void CanPacer::queue(const wire::CanFrame& frame, int sender, Stamp now,
                     std::optional<Stamp> sampled_at) {
  if (waiting_.size() > bound) {
    waiting_.erase(waiting_.begin() + 1);
    ++frames_lost_;
  }
  waiting_.push_back({frame, sender, now, sampled_at});
  if (waiting_.size() == 1) begin_first();
}

std::optional<Stamp> CanPacer::deadline() const {
  if (waiting_.empty()) return std::nullopt;
  return first_ends_;
}

std::optional<CanPacer::Sent> CanPacer::take(Stamp now) {
  if (waiting_.empty() || first_ends_ > now) return std::nullopt;
  const Waiting& first = waiting_.front();
  const Sent sent{first.frame,
                  first_ends_,
                  first.sender,
                  {first.sampled_at, first.queued_at, first_begins_, first_ends_}};
  waiting_.erase(waiting_.begin());
  if (!waiting_.empty()) begin_first();
  return sent;
}

}  // namespace drydock::emulate
