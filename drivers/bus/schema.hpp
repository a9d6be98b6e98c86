#pragma once

#include <string>
#include <string_view>

/// What viewers and recordings need to know of the messages. Made of the IDL files that the wire
/// format is generated from, so the two cannot differ.
namespace drydock::bus {

/// "sensor_msgs::msg::dds_::Imu_", as DDS has it, is "sensor_msgs/msg/Imu" in ROS 2.
std::string ros2_type(std::string_view dds_type);

/// Definition of a ROS 2 type in the form that MCAP calls "ros2msg": its fields as in a .msg file,
/// then those of every type it needs behind a line of 80 '=' and "MSG: package/Type". Throws
/// std::invalid_argument for a type that the bus does not have.
std::string ros2_schema(std::string_view ros2_type);

}  // namespace drydock::bus
