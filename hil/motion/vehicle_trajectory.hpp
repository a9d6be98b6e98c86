#pragma once

#include "hil/motion/truth.hpp"
#include "hil/motion/voyage.hpp"

namespace drydock::motion {

/// The truth of a vehicle that sails a mission by the Gertler-Hagen equations under autopilots, on
/// the rotating Earth, in a current: docs/world/vehicle.md. Between two steps of 10 ms it is one
/// Runge-Kutta step of that part, so velocity, attitude and specific force are continuous and the
/// inertial measurements are the derivatives of the path. The legs repeat as in
/// KinematicTrajectory.
class VehicleTrajectory final : public Trajectory {
 public:
  /// `mission.vehicle` must be there. Throws std::invalid_argument (one line) for a mission that
  /// cannot be sailed.
  VehicleTrajectory(const rig_config::MissionConfig& mission, Stamp start);

  Truth at(Stamp time) const override;  ///< any order, any thread; before start() the first state
  Stamp start() const override { return start_; }
  Stamp end() const override;  ///< of the first lap; the motion itself does not end
  const ocean::Ocean& ocean() const override { return voyage_.motion().ocean(); }

 private:
  Voyage voyage_;
  Stamp start_;
};

}  // namespace drydock::motion
