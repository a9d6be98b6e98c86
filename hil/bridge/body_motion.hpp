#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "hil/bridge/rotation_history.hpp"

namespace drydock::bridge {

/// How the body moved over the bed since a mark.
struct Moved {
  Stamp to{};
  std::chrono::nanoseconds time{};
  Eigen::Vector3d angle_rad = Eigen::Vector3d::Zero();   ///< rotation vector of the body
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< in the body axes of `to`
  bool rotation_known = false;                           ///< false: it counts as none
};

/// Adds up velocities of a DVL to the motion since a mark: the trapezoidal rule, and the turn of
/// the body between two pings. A pause of more than a second makes a new mark.
class BodyMotion {
 public:
  /// Velocity over the bed, m/s in body axes. Empty if no
  /// ping came since the mark.
  std::optional<Moved> add(Stamp at, const Eigen::Vector3d& velocity,
                           const RotationHistory& rotation);
  /// From the newest ping on.
  void mark();
  /// From the next ping on.
  void forget() { last_at_.reset(); }

 private:
  std::optional<Stamp> last_at_;
  Eigen::Vector3d last_velocity_ = Eigen::Vector3d::Zero();
  Stamp marked_at_{};
  Eigen::Quaterniond turned_ = Eigen::Quaterniond::Identity();  ///< since the mark
  Eigen::Vector3d position_m_ = Eigen::Vector3d::Zero();        ///< since it, in body axes of now
  bool rotation_known_ = true;
};

}  // namespace drydock::bridge
