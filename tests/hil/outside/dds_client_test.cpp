// A program of somebody else hears the bus with what `drydock dds-config` prints.
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include "drivers/bus/configuration.hpp"
#include "drivers/bus/publisher.hpp"
#include "drivers/process/child.hpp"
#include "tests/own_domain.hpp"

namespace dds_client_test {

using namespace drydock;

/// Samples at rest until `listener` has printed a line.
std::string first_line(const bus::Participant& participant, process::Child& listener) {
  bus::Publisher publisher(participant, {{"imu", bus::Kind::imu, bus::Provenance::emulated}});
  measurement::ImuSample imu;
  imu.origin.provenance = bus::Provenance::emulated;
  imu.origin.valid_at = imu.origin.received_at =
      measurement::stamp_from_ns(1'795'593'600'000'000'001);
  imu.specific_force = {0.1, -0.2, -9.8};  // forward, right, down
  for (int i = 0; i < 1000; ++i) {
    publisher.publish(bus::Measurement{imu});
    if (const auto line = listener.line(std::chrono::milliseconds{10})) return std::string(*line);
  }
  return {};
}

TEST(DdsConfig, AnotherCycloneProgramHearsTheBusWithIt) {
  const std::uint32_t domain = test::own_domain();
  const bus::Participant participant(domain, "lo");
  process::Child listener({"env", "CYCLONEDDS_URI=" + bus::cyclone_configuration("lo"),
                           DRYDOCK_IMU_LISTENER, "rt/imu/data", "1", std::to_string(domain)},
                          "");
  EXPECT_EQ(first_line(participant, listener), "1795593600.000000001 0.100000 0.200000 9.800000")
      << "forward, left, up";
}

TEST(DdsConfig, AnInterfaceIsNamedInIt) {
  EXPECT_EQ(bus::cyclone_configuration("eth0"),
            "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface "
            "name=\"eth0\"/></Interfaces></General></Domain></CycloneDDS>");
}

}  // namespace dds_client_test
