#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "drivers/device/mounting.hpp"
#include "drivers/measurement/measurement.hpp"

namespace drydock::device {

/// No IMU of a vehicle or rocket measures more (they reach about 2000 deg/s and 100 g). Such a
/// value means that a bit of a float was flipped in a frame without a checksum.
inline constexpr double most_rate_radps = 100, most_force_mps2 = 2000;

inline bool believable(const std::array<std::optional<double>, 3>& values, double most) {
  for (const auto& value : values)
    if (value && !(std::abs(*value) <= most)) return false;
  return true;
}

/// A sample in body axes. Empty unless all six components are there and plausible.
inline std::optional<measurement::ImuSample> make_imu_sample(
    const measurement::Origin& origin, const std::array<std::optional<double>, 3>& rate_radps,
    const std::array<std::optional<double>, 3>& specific_force_mps2, const Mounting& mounting) {
  if (!believable(rate_radps, most_rate_radps)) return {};
  if (!believable(specific_force_mps2, most_force_mps2)) return {};
  Eigen::Vector3d rate, force;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!rate_radps[i] || !specific_force_mps2[i]) return {};
    rate(static_cast<Eigen::Index>(i)) = *rate_radps[i];
    force(static_cast<Eigen::Index>(i)) = *specific_force_mps2[i];
  }
  return measurement::ImuSample{origin, mounting.to_body(force), mounting.to_body(rate)};
}

}  // namespace drydock::device
