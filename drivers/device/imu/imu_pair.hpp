#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include "drivers/device/driver.hpp"
#include "drivers/device/imu/imu_sample.hpp"

namespace drydock::device {

/// Joins the rate and the acceleration of one instant, which an SBG sends in two messages directly
/// one after the other, in either order. Without the device's time a message without a partner
/// within 5 ms gives no sample: half a period at 100 Hz still separates two samples.
class ImuPair {
 public:
  using Components = std::array<std::optional<double>, 3>;
  static constexpr std::chrono::milliseconds window{5};

  void reset() { *this = {}; }

  void set_rate(const measurement::Origin& origin, const Components& rate_radps) {
    rate_ = Half{origin, rate_radps};
    stated_valid_at_.reset();
  }
  /// The rate's message says when its values were true.
  void state(Stamp valid_at) { stated_valid_at_ = valid_at; }

  void set_force(const measurement::Origin& origin, const Components& specific_force_mps2) {
    force_ = Half{origin, specific_force_mps2};
  }

  /// Publishes the sample if both are there and no component is missing.
  void publish(const Mounting& mounting, Output& out) {
    if (!whole() || is_late()) return;  // of a late one the older message has no partner
    if (const auto sample = take(mounting)) out.publish(*sample);
  }

  bool begun() const { return rate_ || force_; }
  bool whole() const { return rate_ && force_; }
  /// The two of a whole pair came too far apart to be one sample by their arrival.
  bool is_late() const {
    return std::chrono::abs(rate_->origin.received_at - force_->origin.received_at) > window;
  }

  /// The sample of a whole pair, however far apart its halves came.
  std::optional<measurement::ImuSample> take(const Mounting& mounting) {
    // Both were sampled together, before the first of the two was sent.
    measurement::Origin origin = rate_->origin;
    origin.received_at = std::max(origin.received_at, force_->origin.received_at);
    origin.valid_at = stated_valid_at_.value_or(std::min(origin.valid_at, force_->origin.valid_at));
    auto sample = make_imu_sample(origin, rate_->components, force_->components, mounting);
    rate_.reset();
    force_.reset();
    return sample;
  }

 private:
  struct Half {
    measurement::Origin origin;
    Components components;
  };

  std::optional<Half> rate_, force_;
  std::optional<Stamp> stated_valid_at_;
};

}  // namespace drydock::device
