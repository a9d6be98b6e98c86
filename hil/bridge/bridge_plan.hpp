#pragma once

#include <boost/system/result.hpp>
#include <memory>
#include <string>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/link/uri.hpp"
#include "hil/bridge/autopilot_feed.hpp"
#include "hil/bridge/run_bridge.hpp"

namespace drydock::bridge {

/// What a bridge opens: one DVL, perhaps an IMU, and the autopilot's link.
struct BridgePlan {
  FeedOptions feed;
  link::Uri autopilot;
  std::vector<std::unique_ptr<device::Device>> devices;  ///< the DVL first
};

/// Why there can be no such bridge: one line with what is allowed.
struct NoPlan {
  std::string message;
};

/// Opens no link.
boost::system::result<BridgePlan, NoPlan> plan_of(const BridgeOptions& options);

}  // namespace drydock::bridge
