#pragma once

#include <span>
#include <vector>

#include "hil/motion/steered/thruster.hpp"
#include "hil/motion/steered/thruster_hull.hpp"
#include "hil/motion/truth.hpp"
#include "hil/motion/vehicle/vehicle_motion.hpp"

namespace drydock::motion {

/// A vehicle with thrusters at one instant.
struct ThrusterState {
  VehicleState vehicle;
  boost::container::static_vector<ThrusterRun, most_thrusters> thrusters;
};

/// The motion of a vehicle with thrusters, in steps of 2.5 ms or less (Runge-Kutta 4). It cannot
/// leave the water, nor sink into the bed.
class ThrusterMotion {
 public:
  /// `mission.thruster_vehicle` must be set.
  explicit ThrusterMotion(const rig_config::MissionConfig& mission);

  const ThrusterState& first() const { return first_; }  ///< at rest where the mission begins

  /// The state dt seconds after `t_s` with held outputs, -1 to 1 each. Missing outputs are 0.
  ThrusterState after(const ThrusterState& state, std::span<const double> outputs, double t_s,
                      double dt) const;
  Truth truth(const ThrusterState& state, double t_s) const;  ///< without its time
  const ocean::Ocean& ocean() const { return ocean_; }

 private:
  using Runs = decltype(ThrusterState::thrusters);

  void drive(Runs& runs, std::span<const double> outputs, double dt) const;
  void short_step(ThrusterState& state, std::span<const double> outputs, double t_s,
                  double h) const;
  VehicleRate rate(const VehicleState& state, const hydrodynamics::Wrench& wrench,
                   double t_s) const;
  hydrodynamics::Wrench wrench(const Runs& runs) const;

  ocean::Ocean ocean_;
  ThrusterHull hull_;
  std::vector<Thruster> thrusters_;
  ThrusterState first_;
  bool shafts_known_;
};

}  // namespace drydock::motion
