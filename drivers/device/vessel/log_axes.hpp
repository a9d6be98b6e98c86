#pragma once

#include <optional>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"

namespace drydock::device {

/// A log's speeds along its own axes -> speeds along those of the body, with the sigma of the rig
/// file. A log that is mounted turned needs both.
class LogAxes {
 public:
  explicit LogAxes(const DriverOptions& options)
      : mounting_(options.mounting), sigma_mps_(options.velocity_sigma_mps) {}

  void publish(const std::optional<double>& longitudinal_mps,
               const std::optional<double>& transverse_mps, const measurement::Origin& origin,
               Output& out) const;

 private:
  Mounting mounting_;
  std::optional<double> sigma_mps_;
};

}  // namespace drydock::device
