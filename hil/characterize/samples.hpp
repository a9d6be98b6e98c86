#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "drivers/measurement/measurement.hpp"
#include "drivers/measurement/sound_speed_used.hpp"
#include "rig_config/rig.hpp"

namespace drydock::characterize {

/// The device that is examined.
struct Subject {
  std::string name;
  rig_config::DeviceKind kind = rig_config::DeviceKind::imu;
  double nominal_rate_hz = 0;  ///< 0: not known
  Eigen::Matrix3d sensor_to_body = Eigen::Matrix3d::Identity();
  Eigen::Vector3d lever_arm_m = Eigen::Vector3d::Zero();  ///< body axes, from the vehicle's origin
  /// What the samples' times count. Without arrivals there is no host's clock.
  enum class Times : std::uint8_t { of_arrival, of_device, none } times = Times::of_arrival;
};

/// The output of a device, in the quantities and axes of its sensor file: IMU rate and specific
/// force, rad/s, m/s2; DVL velocity, m/s; EM log speed ahead and across, m/s; depth absolute
/// pressure, Pa; GNSS position from the first, velocity, north east down, m, m/s; actuator angles
/// and shaft, rad, rad/s; attitude, its heading without a leap at north, rad, rad/s. NaN: the
/// device did not give it.
struct Samples {
  explicit Samples(Subject of) : subject(std::move(of)) {}
  void add(const measurement::Measurement& measurement);

  Subject subject;
  std::vector<measurement::Origin> origins;
  std::array<std::vector<Eigen::Vector3d>, 2> quantities;  ///< primary, secondary
  std::vector<Eigen::Vector3d>
      attitude;  ///< DVL: roll, pitch, heading of its head, rad; else empty
  /// GNSS: arrival by the host's clock minus the time that the fix states.
  std::vector<double> utc_latency_s;
  measurement::SoundSpeedUsed sound_speed;  ///< DVL

 private:
  std::optional<measurement::Geodetic> first_position_;
  double first_height_m_ = 0;
  std::optional<double> heading_rad_;  ///< the last one of a compass; it goes on beyond north
};

}  // namespace drydock::characterize
