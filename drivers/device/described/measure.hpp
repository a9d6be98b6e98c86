#pragma once

#include <optional>

#include "drivers/device/driver_options.hpp"
#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/described/targets.hpp"

namespace drydock::device {

/// The measurement of a kind of sensor from the values of a described message, in body axes; but a
/// log's speeds are for LogAxes. A vector needs all of its components. `options`: mounting, water.
measurement::Measurement measurement_of(const wire::described::Readings& readings,
                                        const measurement::Origin& origin,
                                        const DriverOptions& options);

/// How long ago the values were true when the message's first byte was sent: as it says, or from
/// its two times. Empty: it does not say, or says what cannot be.
std::optional<std::chrono::nanoseconds> age_of(const wire::described::Readings& readings);

/// The time of the device's own clock. Empty: it does not say, or says what no clock shows.
std::optional<std::chrono::nanoseconds> device_time_of(const wire::described::Readings& readings);

}  // namespace drydock::device
