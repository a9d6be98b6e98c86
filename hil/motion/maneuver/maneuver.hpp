#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hil/motion/track.hpp"

/// Standard manoeuvres of ships and submarines (ITTC 7.5-02-06-01, IMO MSC.137(76); the vertical
/// overshoot of submarine trials) and their usual figures.
namespace drydock::motion {

enum class ManeuverKind { turning_circle, zigzag, spiral, dive };

/// "turning-circle", ...; maneuver_kind() is empty for an unknown name.
std::string_view to_string(ManeuverKind kind);
std::optional<ManeuverKind> maneuver_kind(std::string_view name);

struct Maneuver {
  ManeuverKind kind = ManeuverKind::turning_circle;
  double speed_mps = 0;                  ///< commanded during the whole manoeuvre
  std::optional<double> deflection_rad;  ///< rudder or stern planes; empty: the kind's usual one
  double switch_rad =
      0.17453292519943295;  ///< zigzag, dive: change of heading or pitch that reverses
};

/// The time at which the surface is first moved, s.
inline constexpr double execute_s = 10;

/// Why the vehicle cannot sail the manoeuvre, and what is allowed; empty if it can.
std::optional<std::string> refusal(const rig_config::VehicleConfig& vehicle, const Maneuver& m);
double fastest_mps(const rig_config::VehicleConfig& vehicle);  ///< at the propeller's limit

/// Sails a manoeuvre and returns its track:
///   turning_circle  rudder over (default: to its limit) until the heading has turned 540 deg
///   zigzag          rudder over (default 10 deg), reversed five times, each time when the heading
///                   has reached `switch_rad` on the side to which it steers
///   spiral          rudder in steps from one limit (or +-deflection) to the other and back, each
///                   held until the rate of turn is steady
///   dive            stern planes down (default 5 deg) until the bow has gone down by `switch_rad`,
///                   then reversed until the vehicle no longer descends
/// Check refusal() first.
Track sail(const rig_config::VehicleConfig& vehicle, const Maneuver& maneuver);

/// The steady rate of turn at one rudder angle of a spiral.
struct SpiralPoint {
  double rudder_rad = 0, rate_of_turn_radps = 0;
  bool returning = false;  ///< on the way back from the other side
};
std::vector<SpiralPoint> spiral_points(const Track& track);

/// A usual figure of a manoeuvre. It has no value if the track does not reach it.
struct Figure {
  std::string name, unit;  ///< "tactical diameter", "m"
  std::optional<double> value;
};

/// The figures of a track from sail() or from a schedule. The first deflection is the execute.
/// Empty if nothing was deflected.
std::vector<Figure> figures(ManeuverKind kind, const Track& track);

}  // namespace drydock::motion
