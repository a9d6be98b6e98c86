#pragma once

#include <mutex>

#include "hil/motion/leg_profile.hpp"
#include "hil/motion/truth.hpp"
#include "hil/motion/vehicle/checkpoints.hpp"
#include "rig_config/rig.hpp"

namespace drydock::motion {

/// A vehicle that follows its legs exactly. Speed, heading, pitch and roll are twice continuously
/// differentiable functions of time; the inertial measurements follow from them on the rotating
/// WGS-84 Earth. The velocity is along body x. With a pivot ahead of the origin the hull slips
/// through two equal lags: v follows -pivot r, w follows pivot q, and the depth includes this slip.
/// The legs repeat without end; a lap begins with the heading, depth and speed at the end of the
/// previous lap.
class KinematicTrajectory final : public Trajectory {
 public:
  /// Throws std::invalid_argument (one line) for a mission that is not possible.
  KinematicTrajectory(const rig_config::MissionConfig& mission, Stamp start);

  Truth at(Stamp time) const override;  ///< any order, any thread; before start(): the first state
  Stamp start() const override { return start_; }
  Stamp end() const override;  ///< end of the first lap; the motion itself does not end
  const ocean::Ocean& ocean() const override { return ocean_; }

 private:
  /// The integrated values since the start. Slips are v and w; they follow `lagged`.
  struct Path {
    double latitude_rad = 0, longitude_rad = 0, slip_depth_m = 0;
    Eigen::Vector2d lagged = Eigen::Vector2d::Zero(), slip_mps = Eigen::Vector2d::Zero();
  };

  /// What the legs prescribe, with the sines and cosines that every derivative at that time needs.
  struct Course {
    explicit Course(const Prescribed& prescribed);
    Prescribed p;
    double sin_pitch, cos_pitch, sin_yaw, cos_yaw;
  };
  struct Checkpoint {
    Path path, rate;
  };

  void check_clear_of_bed() const;  ///< checks the first lap; throws
  /// `p`: what the legs prescribe at `t`.
  Path path_at(double t, const Prescribed& p) const;
  Checkpoint checkpoint_of(std::size_t index, const Path& path) const;
  Path integrate(const Checkpoint& from, double t, double duration, const Course& at_end) const;
  Path derivative(const Course& course, const Path& path) const;

  Stamp start_;
  ocean::Ocean ocean_;
  MissionProfile profile_;
  double pivot_m_, sideslip_lag_s_;
  double spacing_s_;
  mutable std::mutex mutex_;
  mutable Checkpoints<Checkpoint> checkpoints_;  ///< equally spaced from start()
};

}  // namespace drydock::motion
