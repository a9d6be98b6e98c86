#pragma once

#include <memory>

#include "hil/emulate/sampling_device.hpp"

namespace drydock::emulate {

/// The emulated device of a description, whatever its kind.
std::unique_ptr<EmulatedDevice> make_described(const DeviceSetup& setup);

}  // namespace drydock::emulate
