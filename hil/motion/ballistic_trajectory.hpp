#pragma once

#include <Eigen/Core>
#include <vector>

#include "hil/motion/truth.hpp"
#include "rig_config/rig.hpp"

namespace drydock::motion {

/// A rolling airframe in ballistic flight, like a sounding rocket after burn-out. Gravity, Coriolis
/// acceleration and drag move it. Pitch and yaw follow the velocity except for a small cone of the
/// nose; the rate of the roll angle is constant. docs/world/sky.md has the equations. At the first
/// contact with the ground it stops at once and keeps its attitude.
class BallisticTrajectory final : public Trajectory {
 public:
  /// `mission.ballistic` must be set. Heading and speed are those of the velocity at burn-out.
  /// Throws std::invalid_argument (one line) for a flight that begins below the ground, climbs
  /// above 500 km or does not come down within an hour.
  BallisticTrajectory(const rig_config::MissionConfig& mission, Stamp start);

  Truth at(Stamp time) const override;  ///< any order, any thread; before start(): the first state
  Stamp start() const override { return start_; }
  Stamp end() const override;  ///< the time of landing
  const ocean::Ocean& ocean() const override { return ocean_; }

 private:
  struct State {
    double latitude_rad = 0, longitude_rad = 0, height_m = 0;
    Eigen::Vector3d velocity_ned = Eigen::Vector3d::Zero();
  };
  struct Attitude {
    Eigen::Vector3d angles, rates;  ///< roll, pitch, yaw
  };

  State state_at(double t) const;
  State derivative(const State& s) const;
  State step(const State& s, double h) const;
  Eigen::Vector3d drag_ned(const State& s) const;
  double landing_within_last_step() const;
  Attitude attitude_at(double t, const Eigen::Vector3d& velocity,
                       const Eigen::Vector3d& acceleration) const;

  rig_config::BallisticConfig flight_;
  ocean::Ocean ocean_;
  Stamp start_;
  std::vector<State> checkpoints_;  ///< equally spaced from start() to after the landing
  double landing_s_ = 0;
};

}  // namespace drydock::motion
