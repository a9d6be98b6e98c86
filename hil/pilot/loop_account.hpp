#pragma once

#include <optional>
#include <string>
#include <vector>

namespace drydock::pilot {

/// A quantity of the vehicle over time: as the plan wants it, as it is, and as it would be under
/// the autopilots inside the simulation, which know the truth and use no wire.
struct LoopCurve {
  std::vector<double> wanted, is, in_process;
};

/// All values at the times `t_s` from the start of the run. Headings go on beyond 360 degrees.
struct LoopTrace {
  std::vector<double> t_s;
  LoopCurve heading_deg, depth_m, speed_mps;
};

/// How the vehicle answered one leg that changes a quantity: docs/world/steering.md
struct StepResponse {
  std::string quantity, unit;  ///< "heading", "deg"
  double begins_s = 0, from = 0, to = 0;
  double overshoot = 0;                ///< furthest beyond `to`
  std::optional<double> settling_s;    ///< from begins_s on; empty: not settled
  std::optional<double> steady_error;  ///< is - to at the end; empty: the leg is not held long
};

/// How the vehicle came to a waypoint, by the truth. Metres from where the mission begins.
struct WaypointAccount {
  double north_m = 0, east_m = 0, radius_m = 0;
  std::optional<double>
      passed_s;                  ///< from the start; empty: not come to, or where the first begins
  bool reached = false;          ///< within radius_m; false: abeam of it
  double cross_track_max_m = 0;  ///< from the line that ends here
  double cross_track_end_m = 0;  ///< the same when it was passed; positive to starboard
};

/// How the loop over the wires went.
struct LoopAccount {
  std::vector<StepResponse> responses;
  std::vector<WaypointAccount> waypoints;  ///< all of the mission; empty: it has legs
  /// Largest differences from the autopilots inside the simulation.
  double heading_off_deg = 0, depth_off_m = 0, speed_off_mps = 0, place_off_m = 0;
  LoopTrace trace;
};

}  // namespace drydock::pilot
