#pragma once

#include <mutex>
#include <vector>

#include "hil/motion/leg_profile.hpp"
#include "hil/motion/truth.hpp"
#include "rig_config/rig.hpp"

namespace drydock::motion {

/// A vehicle that keeps exactly to its legs: speed, heading, pitch and roll are twice continuously
/// differentiable functions of time, the velocity lies along body x, and the inertial measurements
/// follow from them on the rotating WGS-84 Earth. The legs repeat for as long as one asks; a lap
/// begins with the heading, depth and speed at which the one before ended.
class KinematicTrajectory final : public Trajectory {
 public:
  /// Throws std::invalid_argument (one line) for a mission that cannot be flown.
  KinematicTrajectory(const rig_config::MissionConfig& mission, Stamp start);

  Truth at(Stamp time) const override;  ///< any order, any thread; before start() the first state
  Stamp start() const override { return start_; }
  Stamp end() const override;  ///< of the first lap; the motion itself does not end
  const ocean::Ocean& ocean() const override { return ocean_; }

 private:
  struct Position {
    double latitude_rad = 0, longitude_rad = 0;
  };

  void check_clear_of_bed() const;  ///< throws; through the first lap
  Position position_at(double t) const;
  Position integrate(Position from, double t, double duration) const;

  Stamp start_;
  ocean::Ocean ocean_;
  MissionProfile profile_;
  mutable std::mutex mutex_;
  mutable std::vector<Position> checkpoints_;  ///< equally spaced from start(), grown on demand
};

}  // namespace drydock::motion
