#include <dds/dds.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "tests/drivers/bus/child_process.hpp"
#include "tests/drivers/bus/wire_reader.hpp"

namespace drydock::bus::test {
namespace {

struct Endpoint {
  std::string type, user_data;
  dds_reliability_kind_t reliability;
  dds_durability_kind_t durability;
};

std::string user_data_of(const dds_qos_t* qos) {
  void* bytes = nullptr;
  std::size_t size = 0;
  if (!dds_qget_userdata(qos, &bytes, &size)) return {};
  std::string text(static_cast<const char*>(bytes), size);
  dds_free(bytes);
  return text;
}

/// The data of its writers that discovery gives to every participant of the domain, by topic.
std::map<std::string, Endpoint> discovered_writers(const Participant& participant) {
  const Entity reader(
      dds_create_reader(participant.handle(), DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr),
      "builtin reader");
  std::map<std::string, Endpoint> writers;
  void* sample = nullptr;
  dds_sample_info_t info;
  while (dds_take(reader.handle(), &sample, &info, 1, 1) == 1) {
    const auto& endpoint = *static_cast<const dds_builtintopic_endpoint_t*>(sample);
    auto& writer = writers[endpoint.topic_name];
    writer = {endpoint.type_name, user_data_of(endpoint.qos), {}, {}};
    dds_duration_t blocking = 0;
    dds_qget_reliability(endpoint.qos, &writer.reliability, &blocking);
    dds_qget_durability(endpoint.qos, &writer.durability);
    dds_return_loan(reader.handle(), &sample, 1);
    sample = nullptr;
  }
  return writers;
}

TEST(BusOnTheWire, TopicsAndTypesAreNamedAsRos2Does) {
  const Participant participant(test_domain());
  const Publisher publisher(participant, ros_devices(), {"leveling"});
  const auto writers = discovered_writers(participant);
  const std::map<std::string, std::string> expected{
      {"rt/imu/data", "sensor_msgs::msg::dds_::Imu_"},
      {"rt/dvl/data", "marine_acoustic_msgs::msg::dds_::Dvl_"},
      {"rt/dvl/twist", "geometry_msgs::msg::dds_::TwistWithCovarianceStamped_"},
      {"rt/dvl/bottom_track", "drydock::msg::dds_::BottomTrack_"},
      {"rt/log/twist", "geometry_msgs::msg::dds_::TwistWithCovarianceStamped_"},
      {"rt/log/speed", "drydock::msg::dds_::WaterSpeed_"},
      {"rt/gps/fix", "sensor_msgs::msg::dds_::NavSatFix_"},
      {"rt/gps/velocity", "geometry_msgs::msg::dds_::TwistWithCovarianceStamped_"},
      {"rt/gps/solution", "drydock::msg::dds_::GnssFix_"},
      {"rt/gps/satellites", "drydock::msg::dds_::GnssSatellites_"},
      {"rt/ctd/pressure", "sensor_msgs::msg::dds_::FluidPressure_"},
      {"rt/ctd/temperature", "sensor_msgs::msg::dds_::Temperature_"},
      {"rt/ctd/depth", "drydock::msg::dds_::Depth_"},
      {"rt/rudder/state", "drydock::msg::dds_::ActuatorState_"},
      {"rt/compass/attitude", "drydock::msg::dds_::Attitude_"},
      {"rt/estimate/leveling", "sensor_msgs::msg::dds_::Imu_"},
      {"rt/diagnostics", "diagnostic_msgs::msg::dds_::DiagnosticArray_"}};
  EXPECT_EQ(writers.size(), expected.size());
  for (const auto& [topic, type] : expected) {
    ASSERT_TRUE(writers.contains(topic)) << topic;
    EXPECT_EQ(writers.at(topic).type, type) << topic;
    EXPECT_EQ(writers.at(topic).reliability, DDS_RELIABILITY_RELIABLE) << topic;
    EXPECT_EQ(writers.at(topic).durability, DDS_DURABILITY_VOLATILE) << topic;
  }
}

TEST(BusOnTheWire, UserDataHoldsTheTypeHashOfRos2AndTheProvenance) {
  const Participant participant(test_domain());
  const Publisher publisher(participant, ros_devices());
  auto writers = discovered_writers(participant);
  EXPECT_EQ(writers["rt/imu/data"].user_data,
            "typehash=RIHS01_7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b;"
            "provenance=emulated;");
  EXPECT_EQ(writers["rt/gps/fix"].user_data,
            "typehash=RIHS01_62223ab3fe210a15976021da7afddc9e200dc9ec75231c1b6a557fc598a65404;"
            "provenance=emulated;");
  EXPECT_EQ(writers["rt/diagnostics"].user_data,
            "typehash=RIHS01_5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e;");
  EXPECT_EQ(writers["rt/rudder/state"].user_data, "provenance=replayed;");
  const Qos qos(dds_create_qos());
  ASSERT_EQ(dds_get_qos(participant.handle(), qos.get()), DDS_RETCODE_OK);
  EXPECT_EQ(user_data_of(qos.get()), "enclave=/;");
}

/// The values that tshark finds in the packets, one on each line.
std::set<std::string> dissected(const std::string& capture, const std::string& field) {
  const std::string command = "tshark -r " + capture + " -Y rtps -T fields -e " + field +
                              " -E occurrence=a -E aggregator='|' 2>/dev/null | tr '|' '\\n'";
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> chunk{};
  while (const auto n = std::fread(chunk.data(), 1, chunk.size(), pipe))
    text.append(chunk.data(), n);
  pclose(pipe);
  std::set<std::string> values;
  for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    values.insert(text.substr(at, end - at));
  return values;
}

/// User data as hexadecimal digits, in the form of tshark.
std::string hex(const std::string& text) {
  std::string digits;
  for (const unsigned char c : text) {
    std::array<char, 3> two{};
    std::snprintf(two.data(), two.size(), "%02x", c);
    digits += two.data();
  }
  return digits;
}

const std::string imu_user_data =
    "typehash=RIHS01_7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b;"
    "provenance=emulated;";

bool file_holds(const std::string& path, const std::string& text) {
  std::ifstream in(path, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  return content.find(text) != std::string::npos;
}

TEST(BusOnTheWire, WiresharkSeesTheNamesTypesAndUserData) {
  if (std::system("command -v tshark >/dev/null") != 0) GTEST_SKIP() << "tshark is not installed";
  const std::string capture = testing::TempDir() + "drydock-bus.pcap";
  const ChildProcess other({"--child", "subscribe", std::to_string(test_domain())});
  EXPECT_EQ(other.read_line(), "subscribed");
  // Cyclone itself writes the capture, so the test needs no right to listen on the interface.
  const std::string configuration =
      "<General><Interfaces><NetworkInterface name=\"lo\" multicast=\"false\"/></Interfaces>"
      "<AllowMulticast>false</AllowMulticast></General>"
      "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
      "<MaxAutoParticipantIndex>100</MaxAutoParticipantIndex>"
      "<Peers><Peer Address=\"127.0.0.1\"/></Peers></Discovery>"
      "<Tracing><PacketCaptureFile>" +
      capture + "</PacketCaptureFile></Tracing>";
  ::setenv("CYCLONEDDS_URI", configuration.c_str(), 1);
  {
    const Participant participant(test_domain());
    const Publisher publisher(participant, all_devices());
    EXPECT_TRUE(eventually([&] { return publisher.matched_readers() == 8; }));
    // This side knows the other's readers, but the other may not yet know our writers.
    eventually([&] { return file_holds(capture, imu_user_data); });
  }
  ::unsetenv("CYCLONEDDS_URI");
  EXPECT_TRUE(dissected(capture, "rtps.param.topicName").contains("rt/imu/data"));
  EXPECT_TRUE(dissected(capture, "rtps.param.typeName").contains("sensor_msgs::msg::dds_::Imu_"));
  const auto user_data = dissected(capture, "rtps.param.userData");
  EXPECT_TRUE(user_data.contains(hex("enclave=/;")));
  EXPECT_TRUE(user_data.contains(hex(imu_user_data)));
  std::filesystem::remove(capture);
}

}  // namespace
}  // namespace drydock::bus::test
