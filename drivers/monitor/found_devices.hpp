#pragma once

#include <memory>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/probe/probe_report.hpp"

namespace drydock::monitor {

/// Makes devices from the blocks that a rig file would contain for the sensors found.
std::vector<std::unique_ptr<device::Device>> devices_of(const probe::ProbeReport& report);

}  // namespace drydock::monitor
