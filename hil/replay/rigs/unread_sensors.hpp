#pragma once

#include <string>
#include <vector>

#include "hil/replay/rigs/capture_parts.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// A line for each kind of sensor that speaks in a part, in a protocol of those devices of the rig
/// that read it, and that none of them is: "ship.log (90 bytes): attitude of nmea0183, 12
/// measurements: no device of this rig reads them".
std::vector<std::string> unread_sensors(const CapturePart& part, const decode::ReplayOptions& how,
                                        const std::vector<rig_config::DeviceConfig>& readers);

}  // namespace drydock::replay
