#pragma once

#include <span>
#include <string_view>

#include "estimators/frame/geodetic.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::steer {

/// The answer of the physics to an autopilot: one line of JSON between two newlines, without a
/// blank. Position is north, east, down of `origin` in m, velocity NED in m/s, specific force
/// (-9.81 along z at rest) and rates in body axes, attitude as a quaternion body to NED; `rng_1` is
/// the height above the bed. Returns the text in `out`; empty: `out` is too small.
std::string_view write_physics(const motion::Truth& truth, double timestamp_s,
                               const frame::Position& origin, std::span<char> out);

}  // namespace drydock::steer
