#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rig_config/fault.hpp"
#include "rig_config/ocean.hpp"
#include "rig_config/places.hpp"
#include "rig_config/thruster_vehicle.hpp"
#include "rig_config/vehicle.hpp"

/// A mission file as typed values: the motion of the emulated vehicle.
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

/// One leg of a mission, with smooth transitions. Without a vehicle the motion follows it exactly;
/// with a vehicle the autopilots follow it.
struct LegConfig {
  LegKind kind = LegKind::straight;
  double duration_s = 0;
  double turn_rad = 0;                     ///< turn: change of heading
  double depth_change_m = 0;               ///< dive: positive down
  double speed_mps = 0;                    ///< speed at the end of the leg
  double amplitude_rad = 0, period_s = 0;  ///< s_path, zigzag: of the heading
  double roll_rad = 0;                     ///< turn without a vehicle: constant heel
  double rate_radps = 0;                   ///< spiral: first rate of turn; zigzag: highest
  double end_rate_radps = 0;               ///< spiral: last rate of turn
  double rudder_rad = 0;                   ///< turning_circle: constant, positive to port
  double ramp_s = 0;  ///< to and from a constant rate (dv/dt, turn, sink); 0: smoothest possible
};

/// A corner of the way that a vehicle sails by line-of-sight guidance. Metres from where the
/// mission begins.
struct WaypointConfig {
  double north_m = 0, east_m = 0;
  double depth_m = 0;    ///< below the surface
  double speed_mps = 0;  ///< through the water, on the line that ends here
  double radius_m = 0;   ///< of the circle of acceptance; 0: two lengths of the vehicle
};

/// docs/world/waypoints.md has the law.
struct GuidanceConfig {
  double lookahead_m = 0;        ///< 0: four lengths of the vehicle
  double integral_gain_mps = 0;  ///< 0: the proportional law
};

/// The flight of a rolling airframe from burn-out to the ground.
struct BallisticConfig {
  double height_m = 0;                    ///< at burn-out, above the ellipsoid
  double ground_height_m = 0;             ///< of the point of impact
  double elevation_rad = 0;               ///< of the velocity at burn-out, above the horizon
  double ballistic_coefficient_kgm2 = 0;  ///< mass / (drag coefficient x area); 0: no air
  double roll_rate_radps = 0;             ///< constant after the spin-up
  double roll_rad = 0;                    ///< at burn-out
  double spin_up_s = 0;                   ///< from roll rate 0 to roll_rate_radps
  double angle_of_attack_rad = 0;         ///< half angle of the nose's cone about the velocity
  double coning_radps = 0;                ///< rate of the nose around this cone
};

/// A way that the vehicle sails instead of legs, as poses in a CSV file.
struct TrackConfig {
  std::string file;
};

/// Another program that steers the vehicle instead of legs.
struct SteeringConfig {
  std::string from;                       ///< "ardupilot": its JSON physics interface
  std::string listen = "127.0.0.1:9002";  ///< address and UDP port
  // "program": docs/world/steering-program.md
  std::vector<std::string> command;  ///< the program and its arguments
  std::string folder;                ///< in which it runs
  double step_s = 0.05;
  double answer_within_s = 2;
  bool truth = false;  ///< it is told the truth
};

struct MissionConfig {
  std::vector<std::string> files;  ///< files that it names: of the vehicle, of the track
  double latitude_rad = 0, longitude_rad = 0, depth_m = 0, heading_rad = 0, speed_mps = 0;
  OceanConfig ocean;
  double pivot_m = 0;           ///< point without side slip in a turn, ahead of the origin
  double sideslip_lag_s = 0.5;  ///< of each of the two lags from turn to side slip
  std::vector<LegConfig> legs;  ///< repeated from the first one if the run lasts longer
  std::vector<WaypointConfig> waypoints;  ///< instead of legs, sailed once; needs a vehicle
  GuidanceConfig guidance;
  std::vector<FaultConfig> faults;
  std::optional<BallisticConfig> ballistic;  ///< instead of legs
  std::optional<TrackConfig> track;          ///< instead of legs
  /// Follows the legs with autopilots; empty: kinematic. A kinematic one has this too if it is
  /// steered: its actuators.
  std::optional<VehicleConfig> vehicle;
  std::optional<ThrusterVehicleConfig> thruster_vehicle;  ///< needs steering
  std::optional<SteeringConfig> steering;                 ///< instead of legs
  PlacesPtr places;                                       ///< of the mission file
};

}  // namespace drydock::rig_config
