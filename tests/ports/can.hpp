#pragma once

#include "tests/hil/survive/bench.hpp"
#include "tests/vcan/process.hpp"

/// What the tests of CAN controllers share.
namespace drydock::ports {

/// `ip link set NAME up type can SETTINGS`
inline void bring_up(const std::string& name, const std::string& settings) {
  const std::string line = "ip link set " + name + " up type can " + settings;
  ASSERT_EQ(vcan::run_program({"sh", "-c", line}), 0) << line;
}

inline rig_config::DeviceConfig depth_on(const std::string& name) {
  return fault::testing::bus_depth("socketcan:" + name + "?emulated=1&bitrate=250000");
}

}  // namespace drydock::ports
