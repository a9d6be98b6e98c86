#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rig_config/fault.hpp"
#include "rig_config/ocean.hpp"
#include "rig_config/vehicle.hpp"

/// A mission file as typed values: where the emulated vehicle goes.
namespace drydock::rig_config {

enum class LegKind : std::uint8_t {
  straight,
  turn,
  dive,
  s_path,
  spiral,
  zigzag,
  turning_circle,
  surface
};

/// One leg of a mission, entered and left smoothly: kept to exactly, or what a vehicle's autopilots
/// follow.
struct LegConfig {
  LegKind kind = LegKind::straight;
  double duration_s = 0;
  double turn_rad = 0;                     ///< turn: change of heading
  double depth_change_m = 0;               ///< dive: positive down
  double speed_mps = 0;                    ///< speed at the end of the leg
  double amplitude_rad = 0, period_s = 0;  ///< s_path, zigzag: of the heading
  double roll_rad = 0;                     ///< turn, kinematic: heel held
  double rate_radps = 0;                   ///< spiral: rate of turn at first; zigzag: highest
  double end_rate_radps = 0;               ///< spiral: rate of turn in the end
  double rudder_rad = 0;                   ///< turning_circle: held, positive to port
  double ramp_s = 0;  ///< to and from a constant rate (dv/dt, turn, sink); 0: as smooth as can be
};

/// A rolling airframe from burn-out to where it comes down.
struct BallisticConfig {
  double height_m = 0;                    ///< at burn-out, above the ellipsoid
  double ground_height_m = 0;             ///< of where it comes down
  double elevation_rad = 0;               ///< of the velocity at burn-out, above the horizon
  double ballistic_coefficient_kgm2 = 0;  ///< mass / (drag coefficient x area); 0: no air
  double roll_rate_radps = 0;             ///< held once spun up
  double roll_rad = 0;                    ///< at burn-out
  double spin_up_s = 0;                   ///< from no roll rate to the one held
  double angle_of_attack_rad = 0;         ///< of the nose's cone about the velocity
  double coning_radps = 0;                ///< rate at which the nose goes around it
};

struct MissionConfig {
  std::vector<std::string> files;  ///< that it names: its vehicle
  double latitude_rad = 0, longitude_rad = 0, depth_m = 0, heading_rad = 0, speed_mps = 0;
  OceanConfig ocean;
  double pivot_m = 0;           ///< ahead of the origin, where a turning hull has no side slip
  double sideslip_lag_s = 0.5;  ///< of each of the two lags between turning and slipping
  std::vector<LegConfig> legs;  ///< repeated from the first when the run lasts longer
  std::vector<FaultConfig> faults;
  std::optional<BallisticConfig> ballistic;  ///< in place of legs
  std::optional<VehicleConfig> vehicle;      ///< sails the legs under autopilots; none: kinematic
};

}  // namespace drydock::rig_config
