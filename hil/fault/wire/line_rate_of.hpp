#pragma once

#include "drivers/link/uri.hpp"
#include "drivers/wire/line_rate.hpp"
#include "rig_config/rig.hpp"

namespace drydock::fault {

/// Rate and bits of a byte of the device's line. Without a line: no rate.
inline wire::LineRate line_rate_of(const rig_config::DeviceConfig& device) {
  const auto uri = link::parse_uri(device.link);
  return uri ? uri->line_rate().value_or(wire::LineRate{}) : wire::LineRate{};
}

}  // namespace drydock::fault
