#pragma once

namespace drydock::rig_config {

struct Node;

/// How an attitude filter begins, and where on the Earth it is.
struct AttitudeStart {
  bool accelerometer = true;  ///< first attitude from the first specific force; false: `initial_*`
  double initial_roll_rad = 0, initial_pitch_rad = 0;
  double latitude_rad = 0, heading_rad = 0;
};

AttitudeStart read_attitude_start(const Node& table);

}  // namespace drydock::rig_config
