#pragma once

#include <array>
#include <chrono>
#include <optional>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/device/mounting.hpp"
#include "drivers/measurement/measurement.hpp"

namespace drydock::device {

/// Angles of a compass's own axes -> angles of the body, without the error that the rig file knows.
/// A heading of turned axes depends on their tilt: that of the last second, or else that of a level
/// body.
class AttitudeAxes {
 public:
  static constexpr std::chrono::seconds tilt_counts_for{1};

  explicit AttitudeAxes(const DriverOptions& options);

  /// Sets roll and pitch of `into`. A turned compass needs both.
  void tilt(const std::optional<double>& roll_rad, const std::optional<double>& pitch_rad,
            measurement::AttitudeSample& into, Output& out);

  /// Sets heading and true heading of `into`, whose other values are those of the message.
  void heading(double heading_rad, measurement::AttitudeSample& into) const;

 private:
  struct Tilt {
    double roll_rad = 0, pitch_rad = 0;
  };
  static Tilt tilt_of(const Eigen::Vector3d& down);
  double turn_to_body(const Tilt& sensor) const;
  double error_at(double shown_rad) const;

  Mounting mounting_;
  std::array<double, 3> error_rad_;
  Tilt level_;  ///< of the sensor's axes while the body is level
  std::optional<Tilt> last_;
  measurement::Stamp last_at_{};
};

}  // namespace drydock::device
