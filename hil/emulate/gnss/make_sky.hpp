#pragma once

#include <boost/system/result.hpp>
#include <memory>

#include "hil/emulate/make_emulated_device.hpp"
#include "hil/sensor/sky.hpp"

namespace drydock::emulate {

/// The satellites of one receiver: those of the ephemeris file in its configuration, or ten
/// invented ones. It is an error if the file cannot be used, or if its records are not valid when
/// the mission begins.
boost::system::result<std::shared_ptr<sensor::Sky>, EmulateError> make_sky(
    const rig_config::DeviceConfig& config, measurement::Stamp mission_start, std::uint64_t seed);

}  // namespace drydock::emulate
