#pragma once

#include <memory>
#include <span>

#include "hil/motion/truth.hpp"
#include "rig_config/mission.hpp"

namespace drydock::motion {

/// A vehicle that another program steers by its outputs, -1 to 1 each. It begins at rest where the
/// mission says. It cannot leave the water, nor sink into the bed.
class SteeredVehicle {
 public:
  virtual ~SteeredVehicle() = default;
  /// Advances by dt seconds with held outputs. Missing outputs are 0.
  virtual void step(std::span<const double> outputs, double dt) = 0;
  virtual Truth truth() const = 0;  ///< without its time
  virtual const ocean::Ocean& ocean() const = 0;
};

/// The thrusters in the order of the vehicle file take the outputs. A vehicle with fins takes those
/// of its actuators, see fins_alone(); without [steering] those of three thrusters, see fins_of().
/// Throws std::invalid_argument for a vehicle that is not possible.
std::unique_ptr<SteeredVehicle> make_steered_vehicle(const rig_config::MissionConfig& mission);

/// How many outputs it takes.
std::size_t outputs_of(const rig_config::MissionConfig& mission);

/// Where a vehicle begins.
struct VehicleState;
VehicleState first_state(const rig_config::MissionConfig& mission);

}  // namespace drydock::motion
