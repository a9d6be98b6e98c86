#pragma once

#include <array>

#include "hil/motion/steered/steered_vehicle.hpp"
#include "hil/motion/vehicle/vehicle_motion.hpp"

namespace drydock::motion {

/// Rudder, stern planes, bow planes and propeller as shares of their limits.
using FinShares = std::array<double, 4>;

/// The rudder, planes and propeller that do what the three thrusters of ArduSub's frame SIMPLEROV_3
/// would do. Outputs 1 and 2 are the thrusters to starboard and to port, output 3 the vertical one,
/// whose positive output pushes down. Forward is the mean of 1 and 2, a turn to starboard half of
/// (2 - 1). A fin gives nothing without speed.
FinShares fin_shares_of(std::span<const double> outputs);
Command fins_of(std::span<const double> outputs, const rig_config::VehicleConfig& vehicle);

/// The outputs are FinShares: positive turns to port, pushes the nose down, pushes it up, ahead.
Command fins_alone(std::span<const double> outputs, const rig_config::VehicleConfig& vehicle);

/// A vehicle with rudder, planes and propeller, sailed by the Gertler-Hagen equations.
class FinVehicle final : public SteeredVehicle {
 public:
  using Mixing = decltype(&fins_of);

  /// `mission.vehicle` must be set.
  FinVehicle(const rig_config::MissionConfig& mission, Mixing mixing);

  void step(std::span<const double> outputs, double dt) override;
  Truth truth() const override;
  const ocean::Ocean& ocean() const override { return motion_.ocean(); }

 private:
  rig_config::VehicleConfig config_;
  Mixing mixing_;
  VehicleMotion motion_;
  Actuators actuators_;
  VehicleState state_;
  double t_s_ = 0;
};

}  // namespace drydock::motion
