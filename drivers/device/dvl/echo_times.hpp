#pragma once

#include <chrono>
#include <optional>

namespace drydock::device {

/// When the echo came, of a DVL that tells it with its velocity. Without bottom lock it does not;
/// then the latest times hold, so that neither age nor device time jumps with each loss.
class EchoTimes {
 public:
  /// `told`: from the trigger to the echo. Zero while none was told.
  std::chrono::nanoseconds after_trigger(std::optional<std::chrono::nanoseconds> told) {
    if (told) after_trigger_ = *told;
    return after_trigger_;
  }
  /// `told`: from the echo to the first byte. Empty while none was told.
  std::optional<std::chrono::nanoseconds> age(std::optional<std::chrono::nanoseconds> told) {
    if (told) age_ = told;
    return age_;
  }

 private:
  std::chrono::nanoseconds after_trigger_{0};
  std::optional<std::chrono::nanoseconds> age_;
};

}  // namespace drydock::device
