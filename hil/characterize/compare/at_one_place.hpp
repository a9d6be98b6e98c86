#pragma once

#include <optional>

#include "hil/characterize/compare/track.hpp"

namespace drydock::characterize {

/// A DVL's velocity, and the velocity that a GNSS receiver predicts there, (7): along x and y of
/// the DVL's own axes, m/s.
struct VelocityPair {
  double t_s = 0;  ///< time of the fix, without the assumed delay
  Eigen::Vector2d sensor, reference;
};

/// Brings the two velocities to one place, one frame and one time.
class AtOnePlace {
 public:
  /// Without an IMU or a compass, only fixes on straight legs count: the heading turns by less than
  /// 0.5 deg/s over the two seconds around. The samples must outlive this object.
  AtOnePlace(const Samples& dvl, const Samples& gnss, const Samples* imu);

  /// True if the DVL has a compass and tilt sensors. Otherwise the vehicle is taken as level and
  /// its heading as the GNSS course.
  bool has_attitude() const { return !attitude_.empty(); }
  const Track& sensor() const { return sensor_; }
  std::size_t fixes() const { return reference_.times().size(); }

  /// The velocities of fix i, if it were true `delay_s` after its valid_at. Empty if one of them
  /// has no value then.
  std::optional<VelocityPair> pair(std::size_t i, double delay_s) const;

 private:
  std::optional<double> heading(double t_s) const;
  bool is_straight(double t_s) const;

  Eigen::Matrix3d body_to_sensor_;
  Eigen::Vector3d arm_;  ///< from the antenna to the DVL, body axes
  bool with_imu_;
  Track sensor_, reference_, attitude_, rate_;
};

}  // namespace drydock::characterize
