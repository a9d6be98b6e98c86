#pragma once

#include "hil/motion/truth.hpp"
#include "hil/motion/vehicle/mission_helm.hpp"
#include "hil/motion/vehicle/voyage.hpp"

namespace drydock::motion {

/// The truth at a time of a voyage that began at `start`: after its last step of 10 ms one shorter
/// Runge-Kutta step. Before `start` it is the first state.
Truth truth_at(const Voyage& voyage, Stamp start, Stamp time);

/// The truth of a vehicle that sails a mission with the Gertler-Hagen equations and autopilots, on
/// the rotating Earth, in a current: docs/world/vehicle.md. Between two steps of 10 ms it is one
/// shorter Runge-Kutta step, so velocity, attitude and specific force are continuous, and the
/// inertial measurements are the derivatives of the path. The legs repeat as in
/// KinematicTrajectory; waypoints do not.
class VehicleTrajectory final : public Trajectory {
 public:
  /// `mission.vehicle` must be set. Throws std::invalid_argument (one line) for a mission that the
  /// vehicle cannot sail.
  VehicleTrajectory(const rig_config::MissionConfig& mission, Stamp start);

  /// Any order, any thread.
  Truth at(Stamp time) const override { return truth_at(voyage_, start_, time); }
  Stamp start() const override { return start_; }
  Stamp end() const override;  ///< end of the first lap; the motion itself does not end
  const ocean::Ocean& ocean() const override { return voyage_.motion().ocean(); }

 private:
  MissionHelm helm_;
  Voyage voyage_;
  Stamp start_;
};

}  // namespace drydock::motion
