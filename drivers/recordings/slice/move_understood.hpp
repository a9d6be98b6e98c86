#pragma once

#include <chrono>
#include <span>
#include <string_view>

#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/slice/displacement.hpp"

namespace drydock::slice {

/// True if a ROS 2 type contains no position, or one that move_position() can move. Visible
/// satellites and their time show the place within some 100 km.
bool may_be_kept(std::string_view type);

/// Shifts every builtin_interfaces/Time of a message.
void shift_stamps(const record::MessageNode& layout, std::span<std::uint8_t> cdr,
                  std::chrono::nanoseconds shift);

/// Moves latitude and longitude of sensor_msgs/NavSatFix and drydock/GnssFix. Heights above the
/// ellipsoid become "not available", because they show the geoid height. False if the message has
/// no position.
bool move_position(std::string_view type, const record::MessageNode& layout,
                   std::span<std::uint8_t> cdr, Displacement& place);

}  // namespace drydock::slice
