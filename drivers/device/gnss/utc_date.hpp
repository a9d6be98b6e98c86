#pragma once

#include <chrono>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

using measurement::Stamp;

/// The date of times of day. Many receivers tell it in one sentence of many (ZDA, RMC), so it is
/// carried on from there, over midnight too.
class UtcDate {
 public:
  /// `utc`: date and time of day that a receiver told in what was received then.
  void told(Stamp utc, Stamp received_at) {
    utc_ = utc;
    received_at_ = received_at;
  }
  void forget() { utc_.reset(); }

  /// The day on which this time is nearest to what has passed since. Empty: no date was told.
  std::optional<Stamp> of(std::chrono::nanoseconds time_of_day, Stamp received_at) const {
    constexpr std::chrono::hours day{24}, half{12};
    if (!utc_) return {};
    const Stamp expected = *utc_ + (received_at - received_at_);
    const Stamp midnight{std::chrono::floor<std::chrono::days>(expected.time_since_epoch())};
    const Stamp utc = midnight + time_of_day;
    return utc > expected + half ? utc - day : utc < expected - half ? utc + day : utc;
  }

 private:
  std::optional<Stamp> utc_;
  Stamp received_at_{};
};

}  // namespace drydock::device
