#pragma once

#include <string>
#include <vector>

#include "drivers/monitor/device_view.hpp"

namespace drydock::monitor {

/// What is wrong with a device now, each in words; empty: nothing is. A silent device, a finding, a
/// rate below four fifths of the rig's, more than one damaged frame in a hundred, a shared port.
std::vector<std::string> problems_of(const DeviceView& device);

/// True if there are devices, and nothing is wrong with any of them.
bool all_well(const std::vector<DeviceView>& devices);

}  // namespace drydock::monitor
