#include <gtest/gtest.h>

#include <cstdlib>

#include "drivers/bus/message_types.hpp"
#include "drivers/bus/schema.hpp"
#include "tests/npm/node.hpp"

namespace drydock::bus {
namespace schema_test {

TEST(Schema, IsThePublishedMessageFileFieldByField) {
  // sensor_msgs/FluidPressure.msg of common_interfaces, without its comments.
  const std::string rule(80, '=');
  EXPECT_EQ(ros2_schema("sensor_msgs/msg/FluidPressure"),
            "std_msgs/Header header\nfloat64 fluid_pressure\nfloat64 variance\n" + rule +
                "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + rule +
                "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n");
}

TEST(Schema, NamesTypesAsRos2Does) {
  EXPECT_EQ(ros2_type("sensor_msgs::msg::dds_::Imu_"), "sensor_msgs/msg/Imu");
  EXPECT_EQ(ros2_type("drydock::msg::dds_::BottomTrack_"), "drydock/msg/BottomTrack");
}

TEST(Schema, OfAnUnknownTypeIsRefused) {
  EXPECT_THROW(ros2_schema("sensor_msgs/msg/Joy"), std::invalid_argument);
}

TEST(Schema, HashesToTheTypeHashesThatRos2Publishes) {
  const std::vector<MessageType> types{
      message_type<ImuMessage>,           message_type<NavSatFixMessage>,
      message_type<FluidPressureMessage>, message_type<TemperatureMessage>,
      message_type<TwistMessage>,         message_type<DvlMessage>,
      message_type<DiagnosticsMessage>,   message_type<JointStateMessage>,
      message_type<WrenchMessage>};
  nlohmann::json definitions;
  for (const auto& type : types) {
    const std::string name = ros2_type(type.descriptor->m_typename);
    definitions[name] = ros2_schema(name);
  }
  // From the ROS 2 Jazzy packages: an independent value of the hash.
  definitions["nav_msgs/msg/Odometry"] = ros2_schema("nav_msgs/msg/Odometry");
  definitions["std_msgs/msg/Header"] = ros2_schema("std_msgs/msg/Header");
  DRYDOCK_NEEDS_NODE();
  auto hashes =
      drydock::test::run_node("tests/drivers/bus/type_hashes.cjs", {}, definitions.dump());
  for (const auto& type : types) {
    const std::string name = ros2_type(type.descriptor->m_typename);
    EXPECT_EQ(hashes[name], type.hash) << name;
  }
  EXPECT_EQ(hashes["nav_msgs/msg/Odometry"],
            "RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0");
  EXPECT_EQ(hashes["std_msgs/msg/Header"],
            "RIHS01_f49fb3ae2cf070f793645ff749683ac6b06203e41c891e17701b1cb597ce6a01");
}

}  // namespace schema_test
}  // namespace drydock::bus
