#pragma once

#include <vector>

#include "hil/motion/steered/steered_vehicle.hpp"
#include "hil/motion/steered/thruster.hpp"
#include "hil/motion/steered/thruster_hull.hpp"
#include "hil/motion/vehicle/vehicle_motion.hpp"

namespace drydock::motion {

/// A vehicle with thrusters, which it drives in steps of 2.5 ms or less (Runge-Kutta 4).
class ThrusterVehicle final : public SteeredVehicle {
 public:
  /// `mission.thruster_vehicle` must be set.
  explicit ThrusterVehicle(const rig_config::MissionConfig& mission);

  void step(std::span<const double> outputs, double dt) override;
  Truth truth() const override;
  const ocean::Ocean& ocean() const override { return ocean_; }

 private:
  void short_step(std::span<const double> outputs, double h);
  VehicleRate rate(const VehicleState& state) const;
  hydrodynamics::Wrench wrench() const;

  ocean::Ocean ocean_;
  ThrusterHull hull_;
  std::vector<Thruster> thrusters_;
  VehicleState state_;
  double t_s_ = 0;
};

}  // namespace drydock::motion
