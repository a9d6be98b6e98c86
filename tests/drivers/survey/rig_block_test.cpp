#include "drivers/survey/rig_block.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "rig_config/load.hpp"

namespace drydock::survey {
namespace rig_block_test {

TEST(RigBlock, ARigOfTheBlocksIsAGoodRig) {
  std::vector<FoundDevice> devices{
      {"", device::Kind::dvl, "pd0", "serial:/dev/ttyUSB0?baud=115200&parity=even&bits=7", 4.98, 0},
      {"", device::Kind::depth, "nmea2000", "socketcan:can0", 9.7, 35},
      {"", device::Kind::depth, "cia404-pressure", "socketcan:can0", {}, 7},
      {"", device::Kind::imu, "cia404-imu", "can:auto?name=bus0", 99.95, 1}};
  name_devices(devices);
  EXPECT_EQ(devices[2].name, "depth_2");
  std::string path = "/tmp/drydock_block_XXXXXX";
  ::close(mkstemp(path.data()));
  std::ofstream rig(path);
  rig << "[rig]\nname = \"probed\"\n";
  for (const auto& device : devices) rig << rig_block(device);
  rig.close();
  const auto loaded = rig_config::load_rig(path);
  ::unlink(path.c_str());
  ASSERT_TRUE(loaded) << to_string(loaded.error().front());
  EXPECT_EQ(loaded->devices.at(0).rate_hz, 5);
  EXPECT_EQ(loaded->devices.at(1).address, 35);
  EXPECT_EQ(loaded->devices.at(3).rate_hz, 100);
}

TEST(RigBlock, DevicesOfEveryKindAreNumberedByTheirKind) {
  std::vector<FoundDevice> devices;
  for (int twice = 0; twice < 2; ++twice)
    for (const auto kind : measurement::kinds)
      devices.push_back({"", kind, "any", "socketcan:can0", {}, 0});
  name_devices(devices);
  for (std::size_t i = 0; i < measurement::kinds.size(); ++i) {
    const std::string kind{to_string(measurement::kinds[i])};
    EXPECT_EQ(devices[i].name, kind);
    EXPECT_EQ(devices[measurement::kinds.size() + i].name, kind + "_2");
  }
}

TEST(RigBlock, AMeasuredRateBecomesTheOneThatWasMeant) {
  EXPECT_EQ(nominal_rate_hz(4.98), 5);
  EXPECT_EQ(nominal_rate_hz(100.4), 100);
  EXPECT_NEAR(nominal_rate_hz(0.5003), 0.5, 1e-12);
  EXPECT_NEAR(nominal_rate_hz(12.53), 12.5, 0.51);
  EXPECT_NEAR(nominal_rate_hz(1.4286), 1.43, 1e-12);
}

}  // namespace rig_block_test
}  // namespace drydock::survey
