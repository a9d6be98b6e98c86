#pragma once

#include "hil/motion/splined/cubic_spline.hpp"
#include "hil/motion/splined/pose.hpp"
#include "hil/motion/truth.hpp"
#include "rig_config/mission.hpp"

namespace drydock::motion {

/// A vehicle that sails through given poses. Latitude, longitude, height and the four parts of the
/// attitude's quaternion are cubic splines of time, so velocity, acceleration and rate of turn are
/// their derivatives and fit together on the rotating WGS-84 Earth. Before the first pose the
/// vehicle comes on straight, behind the last one it lies still.
class SplinedTrajectory final : public Trajectory {
 public:
  /// Reads the mission's file of poses. Throws BadMission.
  SplinedTrajectory(const rig_config::MissionConfig& mission, Stamp start);
  SplinedTrajectory(const Poses& poses, ocean::Ocean ocean, Stamp start);

  Truth at(Stamp time) const override;  ///< any order, any thread
  Stamp start() const override { return start_; }
  Stamp end() const override { return start_ + measurement::from_seconds(end_s_); }
  const ocean::Ocean& ocean() const override { return ocean_; }

 private:
  struct Motion {
    CubicSpline<3>::Point place;     ///< latitude and longitude since the first pose, height
    CubicSpline<4>::Point attitude;  ///< quaternion w, x, y, z, not of unit length
  };
  Motion motion_at(double t) const;
  void check_clear_of_bed(const Poses& poses) const;

  Stamp start_;
  ocean::Ocean ocean_;
  frame::Position origin_;
  double end_s_;
  CubicSpline<3> place_;
  CubicSpline<4> attitude_;
};

}  // namespace drydock::motion
