#pragma once

#include <optional>

#include "drivers/wire/described/targets.hpp"

namespace drydock::device {

/// Roll, pitch and heading of a described message that has a quaternion, where it does not have the
/// angles themselves. `quaternion_*` turns vectors of the sensor (forward, starboard, down) into
/// north, east, down; `enu_quaternion_*` those of forward, port, up into east, north, up (REP 103).
/// Empty: neither came, or its length is not 1 within 2 %.
std::optional<wire::described::Readings> with_angles(const wire::described::Readings& readings);

/// True if a whole quaternion came, of whatever length.
bool has_quaternion(const wire::described::Readings& readings);

}  // namespace drydock::device
