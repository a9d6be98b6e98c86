#pragma once

#include <optional>
#include <string>

#include "drivers/bus/device.hpp"

namespace drydock::host {

/// What hosts have told an emulated device, in words: its settings, the last one at the end.
struct Told {
  std::string device, what;
};

/// One status of `rt/diagnostics`: "gnss/told". Its message are the words.
bus::DeviceStatus status_of(const Told& told);

/// The reverse. Empty if it is another status.
std::optional<Told> told_of(const bus::DeviceStatus& status);

}  // namespace drydock::host
