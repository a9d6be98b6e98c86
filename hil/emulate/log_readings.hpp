#pragma once

#include <cmath>

#include "hil/emulate/sampling_device.hpp"
#include "hil/sensor/ideal.hpp"

namespace drydock::emulate {

/// The speed through the water as a log shows it along its own axes, and the way that it counts.
class LogReadings {
 public:
  explicit LogReadings(const DeviceSetup& setup)
      : errors_(setup.primary_errors()), scale_(setup.config.speed_scale) {}

  /// Along and across, m/s. They count until the next sample, at `rate_hz`.
  Eigen::Vector2d at(const Trajectory& trajectory, Stamp at, const sensor::Mounting& mounting,
                     double rate_hz) {
    const auto ideal = sensor::ideal_log(trajectory, at, mounting);
    const Eigen::Vector3d measured =
        errors_.apply({*ideal.longitudinal_mps, *ideal.transverse_mps, 0}, at);
    Eigen::Vector2d shown = scale_ * measured.head<2>();
    distance_m_ += std::abs(shown.x()) / rate_hz;
    return shown;
  }
  double distance_m() const { return distance_m_; }  ///< since boot

 private:
  sensor::ErrorModel errors_;
  double scale_;
  double distance_m_ = 0;
};

}  // namespace drydock::emulate
