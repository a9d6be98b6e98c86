#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hil/motion/track.hpp"

/// Standard manoeuvres of ships and submarines (ITTC 7.5-02-06-01, IMO MSC.137(76); the vertical
/// overshoot of submarine trials) and the figures that people compare.
namespace drydock::motion {

enum class ManeuverKind { turning_circle, zigzag, spiral, dive };

/// "turning-circle", ...; the reverse gives nothing for another name.
std::string_view to_string(ManeuverKind kind);
std::optional<ManeuverKind> maneuver_kind(std::string_view name);

struct Maneuver {
  ManeuverKind kind = ManeuverKind::turning_circle;
  double speed_mps = 0;                  ///< commanded throughout
  std::optional<double> deflection_rad;  ///< rudder or stern planes; default the kind's usual one
  double switch_rad =
      0.17453292519943295;  ///< zigzag, dive: change of heading, pitch that reverses
};

/// Where the surface is first moved.
inline constexpr double execute_s = 10;

/// Why a vehicle cannot sail it so, what is allowed; nothing when it can.
std::optional<std::string> refusal(const rig_config::VehicleConfig& vehicle, const Maneuver& m);
double fastest_mps(const rig_config::VehicleConfig& vehicle);  ///< at the propeller's limit

/// The track of
///   turning_circle  rudder over (default: to its limit) until the heading has turned 540 deg
///   zigzag          rudder over (default 10 deg), reversed five times, each time that the heading
///                   has come to `switch_rad` on the side it steers to
///   spiral          rudder in steps from one limit (or +-deflection) to the other and back, each
///                   held until the rate of turn stands
///   dive            stern planes down (default 5 deg) until the bow has gone down by `switch_rad`,
///                   then reversed until the vehicle no longer descends
/// What refusal() names must have been asked before.
Track sail(const rig_config::VehicleConfig& vehicle, const Maneuver& maneuver);

/// Where the rate of turn stood at one rudder angle of a spiral.
struct SpiralPoint {
  double rudder_rad = 0, rate_of_turn_radps = 0;
  bool returning = false;  ///< on the way back, from the other side
};
std::vector<SpiralPoint> spiral_points(const Track& track);

/// A number that people compare. What the track did not reach has no value.
struct Figure {
  std::string name, unit;  ///< "tactical diameter", "m"
  std::optional<double> value;
};

/// Of a track that was sailed so, or by a schedule: the first deflection is the execute. Empty
/// where nothing was deflected.
std::vector<Figure> figures(ManeuverKind kind, const Track& track);

}  // namespace drydock::motion
