#pragma once

#include <Eigen/Core>
#include <array>
#include <chrono>
#include <optional>

#include "drivers/device/driver.hpp"
#include "drivers/wire/dvl/water_linked_messages.hpp"

/// What both protocols of a Water Linked DVL say about a velocity.
namespace drydock::device {

/// From the reflection at the bed to the first byte, by the report's two times.
class ReportAge {
 public:
  /// Empty without both times, or if their difference is no age, below 0 or over 2 s: that is
  /// reported once, until one is again.
  std::optional<std::chrono::nanoseconds> of(const wire::water_linked::ReportTimes& times,
                                             Output& out);

 private:
  bool told_ = false;
};

/// (m/s)2 in the DVL's axes, from nine entries by rows. Empty unless all came and each variance is
/// above 0.
std::optional<Eigen::Matrix3d> covariance_of(const std::array<std::optional<double>, 9>& entries);

}  // namespace drydock::device
