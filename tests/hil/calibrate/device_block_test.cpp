#include "hil/calibrate/device_block.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace drydock::calibrate {
namespace {

const std::string rig =
    "[rig]\nname = \"dvl\"\n\n[[device]]\nname = \"imu\"\nmounting_deg = [1, 2, 3]\n\n"
    "[[device]]\nname = \"dvl\"        # the head\nmounting_deg = [0, 0, 45]  # beams\n"
    "[device.sound_speed]\nsource = \"as-sent\"\n";

TEST(DeviceBlock, ReplacesAKeyOfItsDeviceAloneAndKeepsTheComment) {
  const auto text = with_key(rig, "dvl", "mounting_deg", "[0.1, 0, 46]");
  EXPECT_NE(text.find("mounting_deg = [0.1, 0, 46]  # beams\n"), std::string::npos) << text;
  EXPECT_NE(text.find("mounting_deg = [1, 2, 3]\n"), std::string::npos);
  EXPECT_EQ(text.find("[0, 0, 45]"), std::string::npos);
}

TEST(DeviceBlock, AddsAKeyBehindTheName) {
  const auto text = with_key(rig, "dvl", "latency_ms", "12.5");
  EXPECT_NE(text.find("name = \"dvl\"        # the head\nlatency_ms = 12.5\n"), std::string::npos)
      << text;
}

TEST(DeviceBlock, RefusesATableAndAnUnknownDevice) {
  EXPECT_THROW(with_key(rig, "dvl", "sound_speed", "{}"), std::runtime_error);
  EXPECT_THROW(with_key(rig, "gnss", "latency_ms", "1"), std::runtime_error);
}

}  // namespace
}  // namespace drydock::calibrate
