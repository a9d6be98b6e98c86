#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "hil/bridge/autopilot_feed.hpp"
#include "rig_config/rig.hpp"

namespace drydock::bridge {

struct BridgeOptions {
  rig_config::Rig rig;
  std::string device;  ///< name of a DVL; empty: the only one
  std::string to;      ///< link URI of the autopilot
  bool position_delta = true, odometry = false;
  int system = 1, component = wire::mavlink::odometry_component;
  double duration_s = 0;  ///< 0: until Ctrl-C
  bool json = false;      ///< the figures at the end as one JSON object
};

/// `drydock bridge mavlink`: runs the driver of one DVL, and of the rig's first IMU, and sends its
/// motion to an autopilot. Lines about both ends on `err`, the figures on `out`. Exit code: 0; 1 if
/// no motion was sent; 2 for wrong usage.
int bridge_mavlink(const BridgeOptions& options, std::FILE* out, std::FILE* err);

}  // namespace drydock::bridge
