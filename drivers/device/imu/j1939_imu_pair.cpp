#include "drivers/device/imu/j1939_imu_pair.hpp"

#include "drivers/device/imu/lost_message.hpp"

namespace drydock::device {

void J1939ImuPair::reset() {
  order_.reset();
  join_.reset();
  rate_.reset();
  force_.reset();
}

void J1939ImuPair::add(Message message, const Half& half, Output& out) {
  order_.hear(message, half.origin.received_at);
  if (!order_.first()) return add_in_unknown_order(message, half, out);
  auto& mine = of(message);
  const bool is_first = message == *order_.first();
  if (is_first) {
    if (mine) report_lost_message(out);
    rate_.reset();
    force_.reset();
    mine = half;
    join_.begins(half.origin.received_at, out);
    return;
  }
  const auto& first = of(*order_.first());
  if (!first) {
    report_lost_message(out);
    join_.misses();
    return;
  }
  const Stamp first_at = first->origin.received_at;
  mine = half;
  join_.completes(take(), first_at, half.origin.received_at, out);
}

void J1939ImuPair::add_in_unknown_order(Message message, const Half& half, Output& out) {
  of(message) = half;
  if (!rate_ || !force_) return;
  const auto apart = std::chrono::abs(rate_->origin.received_at - force_->origin.received_at);
  if (apart <= SampleJoin::close) {
    if (const auto sample = take()) out.publish(*sample);
  } else {
    (message == Message::rate ? force_ : rate_).reset();  // the older one has no partner
  }
}

/// Both were sampled together, before the first of the two was sent.
std::optional<measurement::ImuSample> J1939ImuPair::take() {
  measurement::Origin origin = rate_->origin;
  const Stamp force_at = force_->origin.received_at;
  // With one frame of the sensor or of others between the two. What comes later was read late.
  const Stamp latest = force_at + 2 * rate_->line_time;
  if (!rate_->states_age) {
    origin.valid_at = std::min(origin.valid_at, force_->origin.valid_at);
  } else if (origin.received_at > latest) {
    origin.valid_at -= origin.received_at - latest;
  }
  origin.received_at = std::max(origin.received_at, force_at);
  auto sample = make_imu_sample(origin, rate_->components, force_->components, mounting_);
  rate_.reset();
  force_.reset();
  return sample;
}

}  // namespace drydock::device
