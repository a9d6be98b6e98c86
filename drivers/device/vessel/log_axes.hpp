#pragma once

#include <optional>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"

namespace drydock::device {

/// A log's speeds along its own axes -> speeds along those of the body, with the scale and the
/// sigma of the rig file. A log that is mounted turned needs both.
class LogAxes {
 public:
  explicit LogAxes(const DriverOptions& options)
      : mounting_(options.mounting),
        scale_(options.speed_scale),
        sigma_mps_(options.velocity_sigma_mps) {}

  /// Sets the speeds of `into`, whose origin is set. False: they are impossible, and were refused.
  bool resolve(const std::optional<double>& longitudinal_mps,
               const std::optional<double>& transverse_mps, measurement::WaterSpeed& into,
               Output& out) const;
  /// The way that it has counted.
  std::optional<double> way(std::optional<double> shown_m) const {
    return shown_m ? std::optional(*shown_m / scale_) : shown_m;
  }
  void publish(const std::optional<double>& longitudinal_mps,
               const std::optional<double>& transverse_mps, const measurement::Origin& origin,
               Output& out) const;

 private:
  Mounting mounting_;
  double scale_;
  std::optional<double> sigma_mps_;
};

}  // namespace drydock::device
