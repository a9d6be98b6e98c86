#pragma once

#include <string>

#include "hil/twin/statistics.hpp"

namespace drydock::twin {

/// Text of a sensor file with these errors: bias, white noise and slow noise of each quantity, and
/// short outages at random. `coarse`: the track is too coarse for what the sensor feels, so only
/// white noise is taken from it.
std::string sensor_text(const DeviceStatistics& statistics, rig_config::DeviceKind kind,
                        bool coarse);

}  // namespace drydock::twin
