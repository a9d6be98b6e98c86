#pragma once

#include <memory>

#include "drivers/decode/replay.hpp"
#include "drivers/device/device.hpp"
#include "drivers/link/uri.hpp"

namespace drydock::decode {

/// The link to the capture.
link::Uri uri_of(const ReplayOptions& options);

/// The driver for the capture. Throws std::invalid_argument with one line if there is none, or if
/// the capture holds what it cannot read.
std::unique_ptr<device::Device> replayed_device(const ReplayOptions& options, const link::Uri& uri);

}  // namespace drydock::decode
