#pragma once

#include <string_view>

namespace drydock::exporting {

/// Unit of a message's field, as of ROS 2's definitions and docs/build/bus.md; empty: a pure
/// number, a count, an enumeration, or a type that is not known. `field` is the path: "velocity.x".
std::string_view unit_of(std::string_view type, std::string_view field);

}  // namespace drydock::exporting
