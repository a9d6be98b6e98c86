#pragma once

#include <mutex>

#include "hil/motion/leg_profile.hpp"
#include "hil/motion/truth.hpp"
#include "hil/motion/vehicle/checkpoints.hpp"
#include "rig_config/rig.hpp"

namespace drydock::motion {

/// A vehicle that keeps exactly to its legs: speed, heading, pitch and roll are twice continuously
/// differentiable functions of time, and the inertial measurements follow from them on the rotating
/// WGS-84 Earth. The velocity lies along body x; with a pivot ahead of the origin the hull slips
/// through two equal lags: v follows -pivot r, w follows pivot q, and the depth what comes of it.
/// The legs repeat for as long as one asks; a lap begins with the heading, depth and speed at which
/// the one before ended.
class KinematicTrajectory final : public Trajectory {
 public:
  /// Throws std::invalid_argument (one line) for a mission that cannot be flown.
  KinematicTrajectory(const rig_config::MissionConfig& mission, Stamp start);

  Truth at(Stamp time) const override;  ///< any order, any thread; before start() the first state
  Stamp start() const override { return start_; }
  Stamp end() const override;  ///< of the first lap; the motion itself does not end
  const ocean::Ocean& ocean() const override { return ocean_; }

 private:
  /// What is integrated from the start on; slips are v and w, `lagged` what they follow.
  struct Path {
    double latitude_rad = 0, longitude_rad = 0, slip_depth_m = 0;
    Eigen::Vector2d lagged = Eigen::Vector2d::Zero(), slip_mps = Eigen::Vector2d::Zero();
  };

  void check_clear_of_bed() const;  ///< throws; through the first lap
  Path path_at(double t) const;
  Path integrate(const Path& from, double t, double duration) const;
  Path derivative(const Prescribed& p, const Path& path) const;

  Stamp start_;
  ocean::Ocean ocean_;
  MissionProfile profile_;
  double pivot_m_, sideslip_lag_s_;
  double spacing_s_;
  mutable std::mutex mutex_;
  mutable Checkpoints<Path> checkpoints_;  ///< equally spaced from start()
};

}  // namespace drydock::motion
