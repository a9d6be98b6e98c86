#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/device/driver_options.hpp"
#include "drivers/wire/described/description.hpp"

namespace drydock::survey {

/// A sensor that was found, in the terms of a rig file (docs/use/configuration.md).
struct FoundDevice {
  std::string name;  ///< unique among the devices found
  device::Kind kind = device::Kind::dvl;
  std::string protocol;
  std::string link;                               ///< a driver can open the link with this URI
  std::optional<double> rate_hz;                  ///< as measured
  std::uint8_t address = 0;                       ///< 0: the device has none, or any
  wire::described::DescriptionPtr description{};  ///< of a protocol that a file describes
  std::string evidence{};                         ///< on a bus: what speaks for the description
};

/// Measured rates scatter by a few percent. Gives the nearest integer if it is close enough,
/// otherwise three digits.
double nominal_rate_hz(double measured_hz);

/// The `[[device]]` block to paste. It passes `drydock check`.
std::string rig_block(const FoundDevice& device);

/// Names each device without a name after its kind. From the second on it adds a number.
void name_devices(std::vector<FoundDevice>& devices);

}  // namespace drydock::survey
