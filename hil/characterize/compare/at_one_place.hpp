#pragma once

#include <optional>

#include "hil/characterize/compare/track.hpp"

namespace drydock::characterize {

/// A DVL's velocity and what a GNSS receiver's says that it should be there, (7): along x and y of
/// the DVL's own axes, m/s.
struct VelocityPair {
  double t_s = 0;  ///< of the fix, whatever delay was asked for
  Eigen::Vector2d sensor, reference;
};

/// Brings the two velocities to one place, one frame and one time.
class AtOnePlace {
 public:
  /// Without an IMU, or a compass, only fixes on straight legs count: the heading turns by less
  /// than 0.5 deg/s over the two seconds around. The samples must outlive this.
  AtOnePlace(const Samples& dvl, const Samples& gnss, const Samples* imu);

  /// The DVL has a compass and tilt sensors. Else the vehicle is taken as level and its heading as
  /// the GNSS course.
  bool has_attitude() const { return !attitude_.empty(); }
  const Track& sensor() const { return sensor_; }
  std::size_t fixes() const { return reference_.times().size(); }

  /// Fix i, were it true `delay_s` after its valid_at. Empty: one of both says nothing then.
  std::optional<VelocityPair> pair(std::size_t i, double delay_s) const;

 private:
  std::optional<double> heading(double t_s) const;
  bool is_straight(double t_s) const;

  Eigen::Matrix3d body_to_sensor_;
  Eigen::Vector3d arm_;  ///< from antenna to DVL, body
  bool with_imu_;
  Track sensor_, reference_, attitude_, rate_;
};

}  // namespace drydock::characterize
