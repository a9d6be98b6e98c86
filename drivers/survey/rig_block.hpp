#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/device/driver_options.hpp"

namespace drydock::survey {

/// A sensor that was found, as a rig file names it (docs/use/configuration.md).
struct FoundDevice {
  std::string name;  ///< unique among what was found
  device::Kind kind = device::Kind::dvl;
  std::string protocol;
  std::string link;               ///< URI with which a driver can open it
  std::optional<double> rate_hz;  ///< as measured
  std::uint8_t address = 0;       ///< 0: none, or any
};

/// Measured rates scatter by a few percent: the whole number nearby, else three digits.
double nominal_rate_hz(double measured_hz);

/// The `[[device]]` block to paste; passes `drydock check`.
std::string rig_block(const FoundDevice& device);

/// Gives each device without a name one: its kind, with a number from the second on.
void name_devices(std::vector<FoundDevice>& devices);

}  // namespace drydock::survey
