#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/wire/dvl/dvl_frame.hpp"

namespace drydock::device {

/// The way from a DVL's four components to the velocity of the body: by wire/dvl_frame.hpp from the
/// frame that it sends to its own axes, by the mounting from there to the body. What is missing on
/// that way is reported, once until it changes.
class DvlSolution {
 public:
  explicit DvlSolution(const DriverOptions& options)
      : mounting_(options.mounting), dvl_(options.dvl) {}

  /// m/s, body; empty without lock or without what the frame needs.
  std::optional<Eigen::Vector3d> velocity(const wire::DvlComponents& sent,
                                          wire::DvlGeometry geometry,
                                          const wire::DvlAttitude& attitude, Output& out);

 private:
  void heed(std::string_view missing, Output& out);

  Mounting mounting_;
  DvlOptions dvl_;
  std::string_view missing_;
};

/// Height over a flat bed from the vertical components of the four ranges; empty where no pair of
/// opposite beams is whole or the tilt is not known.
std::optional<double> altitude_over_bed(const std::array<std::optional<double>, 4>& range_m,
                                        const wire::DvlAttitude& tilt);

}  // namespace drydock::device
