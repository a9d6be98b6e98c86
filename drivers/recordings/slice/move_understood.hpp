#pragma once

#include <chrono>
#include <span>
#include <string_view>

#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/slice/displacement.hpp"

namespace drydock::slice {

/// Whether a ROS 2 type holds no position, or one that move_position() knows. Satellites seen do
/// tell the place, to some 100 km with their time.
bool may_be_kept(std::string_view type);

/// Every builtin_interfaces/Time of a message.
void shift_stamps(const record::MessageNode& layout, std::span<std::uint8_t> cdr,
                  std::chrono::nanoseconds shift);

/// Latitude and longitude of sensor_msgs/NavSatFix and drydock/GnssFix; the heights above the
/// ellipsoid, which tell the geoid's, become "not available". False: the message has none.
bool move_position(std::string_view type, const record::MessageNode& layout,
                   std::span<std::uint8_t> cdr, Displacement& place);

}  // namespace drydock::slice
