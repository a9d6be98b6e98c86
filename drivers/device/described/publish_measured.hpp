#pragma once

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/wire/described/targets.hpp"

namespace drydock::device {

/// Publishes what the values of one sample measure. A sample that cannot be true, or an IMU's
/// without all its components, is refused. The device's time is taken from the values.
void publish_measured(const wire::described::Readings& readings, measurement::Origin origin,
                      const DriverOptions& options, Output& out);

}  // namespace drydock::device
