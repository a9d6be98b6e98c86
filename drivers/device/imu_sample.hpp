#pragma once

#include <array>
#include <optional>

#include "drivers/device/mounting.hpp"
#include "drivers/measurement/measurement.hpp"

namespace drydock::device {

/// A sample in body axes; empty unless all six components are there.
inline std::optional<measurement::ImuSample> make_imu_sample(
    const measurement::Origin& origin, const std::array<std::optional<double>, 3>& rate_radps,
    const std::array<std::optional<double>, 3>& specific_force_mps2, const Mounting& mounting) {
  Eigen::Vector3d rate, force;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!rate_radps[i] || !specific_force_mps2[i]) return {};
    rate(static_cast<Eigen::Index>(i)) = *rate_radps[i];
    force(static_cast<Eigen::Index>(i)) = *specific_force_mps2[i];
  }
  return measurement::ImuSample{origin, mounting.to_body(force), mounting.to_body(rate)};
}

}  // namespace drydock::device
