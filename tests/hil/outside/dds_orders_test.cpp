// A program of somebody else orders the joints of the emulated vehicle over DDS.
#include <dds/dds.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <thread>

#include "drivers/bus/configuration.hpp"
#include "drivers/bus/order_reader.hpp"
#include "drivers/process/child.hpp"
#include "ros2_messages.h"
#include "tests/own_domain.hpp"

namespace dds_orders_test {

using namespace drydock;
using measurement::BodyWrench;
using measurement::JointOrder;

/// What a reader hears until `done`, for 20 s at most.
struct Ears {
  bus::Participant participant{test::own_domain(), "lo"};
  bus::OrderReader reader{participant};
  std::vector<std::vector<JointOrder>> joints;
  std::vector<BodyWrench> wrenches;

  template <class Done>
  void listen(Done done) {
    for (int i = 0; i < 2000 && !done(); ++i) {
      reader.take([&](const auto& orders) { joints.push_back(orders); },
                  [&](const auto& wrench) { wrenches.push_back(wrench); });
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
  }
};

TEST(DdsOrders, APlainCycloneProgramOrdersAJoint) {
  Ears ears;
  process::Child program(
      {"env", "CYCLONEDDS_URI=" + bus::cyclone_configuration("lo"), DRYDOCK_JOINT_ORDERS,
       "rear-port", "effort", "12.5", "20", std::to_string(test::own_domain())},
      "");
  ears.listen([&] { return ears.joints.size() >= 3; });
  ASSERT_GE(ears.joints.size(), 3u);
  ASSERT_EQ(ears.joints[0].size(), 1u);
  EXPECT_EQ(ears.joints[0][0].name, "rear-port");
  EXPECT_EQ(ears.joints[0][0].effort_n, 12.5);
  EXPECT_FALSE(ears.joints[0][0].position_rad || ears.joints[0][0].velocity_radps);
}

/// A writer of raw messages, with Cyclone's own functions.
template <class Message>
class Writer {
 public:
  Writer(const bus::Participant& participant, const dds_topic_descriptor_t& type,
         const char* topic) {
    dds_qos_t* qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    dds_qset_history(qos, DDS_HISTORY_KEEP_ALL, 0);
    writer_ = dds_create_writer(
        participant.handle(),
        dds_create_topic(participant.handle(), &type, topic, nullptr, nullptr), qos, nullptr);
    dds_delete_qos(qos);
  }
  void write(const Message& message) { EXPECT_EQ(dds_write(writer_, &message), DDS_RETCODE_OK); }

 private:
  dds_entity_t writer_;
};

TEST(DdsOrders, AWrenchInForwardLeftUpIsForwardRightDown) {
  Ears ears;
  Writer<geometry_msgs_msg_dds__Wrench_> writer(
      ears.participant, geometry_msgs_msg_dds__Wrench__desc, bus::wrench_orders_topic);
  ears.listen([&] { return ears.reader.matched_writers() == 1; });
  writer.write({{1, 2, 3}, {4, 5, 6}});
  writer.write({{NAN, 2, 3}, {4, 5, 6}});
  ears.listen([&] { return ears.reader.unusable() == 1; });
  ASSERT_EQ(ears.wrenches.size(), 1u);
  EXPECT_EQ(ears.wrenches[0].force_n, Eigen::Vector3d(1, -2, -3));
  EXPECT_EQ(ears.wrenches[0].moment_nm, Eigen::Vector3d(4, -5, -6));
}

TEST(DdsOrders, ListsThatDoNotFitTheNamesAreNoOrder) {
  Ears ears;
  Writer<sensor_msgs_msg_dds__JointState_> writer(
      ears.participant, sensor_msgs_msg_dds__JointState__desc, bus::joint_orders_topic);
  ears.listen([&] { return ears.reader.matched_writers() == 1; });
  char rudder[] = "rudder", planes[] = "stern_planes", none[] = "";
  char* names[] = {rudder, planes};
  double values[] = {0.1, -0.2, 0.3}, infinite[] = {0.1, INFINITY};
  sensor_msgs_msg_dds__JointState_ order{};
  order.header.frame_id = none;
  writer.write(order);  // no names
  order.name._buffer = names;
  order.name._length = 2;
  order.position._buffer = values;
  order.position._length = 3;
  writer.write(order);
  order.position._buffer = infinite;
  order.position._length = 2;
  writer.write(order);
  order.position._buffer = values;
  writer.write(order);
  ears.listen([&] { return !ears.joints.empty(); });
  EXPECT_EQ(ears.reader.unusable(), 3u);
  ASSERT_EQ(ears.joints.size(), 1u);
  EXPECT_EQ(ears.joints[0][1].name, "stern_planes");
  EXPECT_EQ(ears.joints[0][1].position_rad, -0.2);
}

}  // namespace dds_orders_test
