#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/wire/dvl/dvl_frame.hpp"

namespace drydock::device {

/// Converts a DVL's four components to the velocity of the body. wire/dvl_frame.hpp goes from the
/// frame on the wire to the sensor's axes, the mounting from there to the body. Missing data are
/// reported once, until something else is missing.
class DvlSolution {
 public:
  explicit DvlSolution(const DriverOptions& options)
      : mounting_(options.mounting), dvl_(options.dvl) {}

  /// m/s, body. Empty without lock, or if data that the frame needs are missing.
  std::optional<Eigen::Vector3d> velocity(const wire::DvlComponents& sent,
                                          wire::DvlGeometry geometry,
                                          const wire::DvlAttitude& attitude, Output& out);

 private:
  void heed(std::string_view missing, Output& out);

  Mounting mounting_;
  DvlOptions dvl_;
  std::string_view missing_;
};

/// Height over a flat bed from the vertical components of the four ranges. Empty if no pair of
/// opposite beams is complete, or if the tilt is not known.
std::optional<double> altitude_over_bed(const std::array<std::optional<double>, 4>& range_m,
                                        const wire::DvlAttitude& tilt);

}  // namespace drydock::device
