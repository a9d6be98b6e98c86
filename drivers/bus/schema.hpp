#pragma once

#include <string>
#include <string_view>

/// The descriptions of messages that viewers and recordings need. They come from the IDL files from
/// which the wire format is generated, so the two cannot differ.
namespace drydock::bus {

/// Example: DDS has "sensor_msgs::msg::dds_::Imu_"; the result is "sensor_msgs/msg/Imu", as in ROS
/// 2.
std::string ros2_type(std::string_view dds_type);

/// Definition of a ROS 2 type in the form that MCAP calls "ros2msg". First come its fields as in a
/// .msg file. Then follow the fields of every type that it needs, each after a line of 80 '=' and
/// "MSG: package/Type". Throws std::invalid_argument for a type that the bus does not have.
std::string ros2_schema(std::string_view ros2_type);

}  // namespace drydock::bus
