#pragma once

#include <string_view>

namespace drydock::exporting {

/// Unit of a message's field, from ROS 2's definitions and docs/build/bus.md. Empty for a pure
/// number, a count, an enumeration, or an unknown type. `field` is the path: "velocity.x".
std::string_view unit_of(std::string_view type, std::string_view field);

}  // namespace drydock::exporting
