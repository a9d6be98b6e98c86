#pragma once

#include <charconv>

#include "drivers/device/bus/source_filter.hpp"
#include "drivers/device/driver.hpp"
#include "drivers/device/fixed_text.hpp"

namespace drydock::device {

/// Decides which of several engines or sensors of one sender is ours: the configured instance or,
/// without one, the first that is heard. It stays ours until it is silent for as long as a sender
/// may be.
class InstanceFilter {
 public:
  using Instance = std::optional<std::uint8_t>;

  /// `what` is a part of the sentence that refuses another one; it must have static storage.
  InstanceFilter(std::string_view what, Instance configured)
      : what_(what), configured_(configured), ours_(configured) {}

  /// False: this instance is another one. That is news unless the file chose.
  bool accepts(Instance instance, measurement::Stamp now, Output& out) {
    const bool lost = !heard_at_ || now - *heard_at_ > SourceFilter::lost_after;
    if (!configured_ && lost) ours_ = instance;
    if (ours_ == instance) {
      heard_at_ = now;
      return true;
    }
    if (!configured_) out.refuse(refusal(instance).view(), Refusal::of_another);
    return false;
  }

 private:
  Reason refusal(Instance instance) const {
    Reason text(what_);
    text += " instance ";
    add(text, instance);
    text += " was left out: instance ";
    add(text, ours_);
    text += " came first; the key instance chooses";
    return text;
  }
  static void add(Reason& text, Instance instance) {
    std::array<char, 3> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), instance.value_or(0)).ptr;
    text += instance ? std::string_view(digits.begin(), end) : "unknown";
  }

  std::string_view what_;
  Instance configured_, ours_;
  std::optional<measurement::Stamp> heard_at_;
};

}  // namespace drydock::device
