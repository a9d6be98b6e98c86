#pragma once

#include <vector>

#include "drivers/bus/device.hpp"
#include "hil/fault/schedule/schedules.hpp"

namespace drydock::control {

/// The faults in the form for pages and recordings.
std::vector<bus::Fault> bus_faults(const std::vector<fault::FaultNow>& faults);

}  // namespace drydock::control
