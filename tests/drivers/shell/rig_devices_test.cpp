#include "drivers/shell/rig_devices.hpp"

#include <gmock/gmock.h>

namespace drydock::shell {
namespace {

using rig_config::DeviceConfig;
using rig_config::DeviceKind;
using testing::HasSubstr;
using testing::StartsWith;

rig_config::Rig rig_of(std::vector<DeviceConfig> devices) {
  rig_config::Rig rig;
  rig.file = "boat.toml";
  rig.devices = std::move(devices);
  return rig;
}

DeviceConfig dvl() {
  DeviceConfig config;
  config.name = "bottom";
  config.kind = DeviceKind::dvl;
  config.protocol = "pd0";
  config.link = "pty:dvl?baud=115200";
  config.rate_hz = 5;
  config.stale_after_s = 1.5;
  config.reopen_after_s = 4;
  config.latency_s = 0.02;
  config.line = 12;
  return config;
}

DeviceConfig depth() {
  DeviceConfig config;
  config.name = "keller";
  config.kind = DeviceKind::depth;
  config.protocol = "nmea2000";
  config.link = "memory-can:bus0";
  config.address = 35;
  config.water_density_kgm3 = 1000;
  config.line = 30;
  return config;
}

TEST(RigDevices, OptionsAreThoseOfTheFile) {
  const auto rig = rig_of({depth(), dvl()});
  const auto options = *device_options(rig, 1);
  EXPECT_EQ(options.name, "bottom");
  EXPECT_EQ(options.driver.kind, device::Kind::dvl);
  EXPECT_EQ(options.driver.device, 1);
  EXPECT_EQ(options.driver.baud, 115200U);
  EXPECT_EQ(options.driver.latency, std::chrono::milliseconds{20});
  EXPECT_EQ(options.nominal_rate_hz, 5);
  EXPECT_EQ(options.life_cycle.stale_after, std::chrono::milliseconds{1500});
  EXPECT_EQ(options.life_cycle.reopen_after, std::chrono::seconds{4});
  EXPECT_TRUE(options.life_cycle.reopen_when_quiet);
}

TEST(RigDevices, QuietBusIsNotOpenedAgainNorIsARecording) {
  auto recorded = dvl();
  recorded.link = "file:dive.pd0?baud=115200";
  const auto rig = rig_of({depth(), recorded});
  EXPECT_FALSE(device_options(rig, 0)->life_cycle.reopen_when_quiet);
  EXPECT_EQ(device_options(rig, 0)->driver.address, 35);
  EXPECT_EQ(device_options(rig, 0)->driver.bitrate, 250'000U);
  EXPECT_FALSE(device_options(rig, 1)->life_cycle.reopen_when_quiet);
}

TEST(RigDevices, ADvlIsToldItsMakerBeamAngleAndSettings) {
  auto config = dvl();
  EXPECT_FALSE(device_options(rig_of({config}), 0)->driver.dvl.water_linked);
  config.maker = rig_config::DvlMaker::water_linked;
  config.beam_angle_rad = 0.5;
  config.water_linked = rig_config::WaterLinkedConfig{1490, 0.25, true};
  const auto options = device_options(rig_of({config}), 0)->driver.dvl;
  EXPECT_EQ(options.maker, device::DvlMaker::water_linked);
  EXPECT_EQ(options.beam_angle_rad, 0.5);
  EXPECT_EQ(options.water_linked->sound_speed_mps, 1490);
  EXPECT_EQ(options.water_linked->mounting_rotation_rad, 0.25);
  EXPECT_TRUE(options.water_linked->old_sentences);
}

TEST(RigDevices, DevicesStandInTheOrderOfTheFile) {
  const auto devices = make_devices(rig_of({depth(), dvl()}));
  ASSERT_TRUE(devices);
  ASSERT_EQ(devices->size(), 2U);
  EXPECT_EQ((*devices)[0]->name(), "keller");
  EXPECT_TRUE((*devices)[0]->on_bus());
  EXPECT_FALSE((*devices)[1]->on_bus());
  EXPECT_EQ((*devices)[1]->index(), 1);
}

std::string error_of(const DeviceConfig& config) {
  const auto devices = make_devices(rig_of({config}));
  return devices ? "" : devices.error().message;
}

TEST(RigDevices, MistakesAreOneLineThatNamesThePlace) {
  auto wrong = dvl();
  wrong.protocol = "pd7";
  EXPECT_THAT(
      error_of(wrong),
      StartsWith(
          "boat.toml:12: device \"bottom\": no driver for kind \"dvl\" with protocol \"pd7\" "
          "over bytes; allowed: pd0 (bytes) pd4 (bytes) "
          "pd5 (bytes) pd6 (bytes) water-linked (bytes) water-linked-json (bytes) "
          "nortek (bytes)"));
  wrong = dvl();
  wrong.link = "carrier-pigeon:x";
  EXPECT_THAT(error_of(wrong), HasSubstr("boat.toml:12: device \"bottom\": "));
  wrong = dvl();
  wrong.link = "memory-can:bus0";
  EXPECT_THAT(error_of(wrong), HasSubstr("protocol \"pd0\" needs a byte link"));
  wrong = depth();
  wrong.link = "pty:depth";
  EXPECT_THAT(error_of(wrong), HasSubstr("protocol \"nmea2000\" needs a CAN link"));
  wrong = depth();
  wrong.address = 254;  // the null address of J1939
  EXPECT_THAT(error_of(wrong), HasSubstr("address 254 is no bus address; allowed: 0 (any) to 253"));
}

DeviceConfig imu(std::string protocol) {
  DeviceConfig config;
  config.name = "imu";
  config.kind = DeviceKind::imu;
  config.protocol = std::move(protocol);
  config.link = "memory-can:bus0";
  config.rate_hz = 100;
  return config;
}

TEST(RigDevices, SettingsOfAnAceinnaImuAreTheNumbersOfItsMessages) {
  auto config = imu("aceinna");
  config.aceinna = {50, "off", 25, 5, "-X-Y+Z"};
  const auto settings = device_options(rig_of({config}), 0)->driver.aceinna;
  EXPECT_EQ(settings.rate_divider, 2);
  EXPECT_EQ(settings.packets, 6);
  ASSERT_TRUE(settings.filter);
  EXPECT_EQ(settings.filter->acceleration_hz, 5);
  EXPECT_EQ(settings.orientation, 0x0009);
  EXPECT_FALSE(device_options(rig_of({imu("aceinna")}), 0)->driver.aceinna.any());
}

TEST(RigDevices, SettingsThatNoAceinnaImuHasAreErrors) {
  auto config = imu("aceinna");
  config.aceinna.packet_rate_hz = 30;
  EXPECT_THAT(error_of(config), HasSubstr("30 is none of its rates"));
  config.aceinna = {};
  config.aceinna.rate_filter_hz = 25;
  EXPECT_THAT(error_of(config), HasSubstr("go together"));
  config.aceinna = {};
  config.aceinna.orientation = "-X+Y+Z";
  EXPECT_THAT(error_of(config), HasSubstr("no right-handed set of axes"));
}

TEST(RigDevices, IdentifiersOfAnXsensImuDifferAndFitTheirFormat) {
  auto config = imu("xsens");
  config.xsens.identifiers = {{"rate_of_turn", 0x132}};
  EXPECT_EQ(encode(wire::xsens::RateOfTurn{},
                   device_options(rig_of({config}), 0)->driver.xsens_identifiers)
                .id,
            0x132U);
  config.xsens.identifiers = {{"rate_of_turn", 0x034}};  // identifier of the acceleration
  EXPECT_THAT(error_of(config), HasSubstr("two are the same"));
}

TEST(RigDevices, SyncIsSentAtTheRateOfTheDevice) {
  auto config = imu("epson-g552");
  config.sync = true;
  config.heartbeat_timeout_s = 1.5;
  const auto canopen = device_options(rig_of({config}), 0)->driver.canopen;
  EXPECT_EQ(canopen.sync_period, std::chrono::milliseconds{10});
  EXPECT_EQ(canopen.heartbeat_timeout, std::chrono::milliseconds{1500});
}

}  // namespace
}  // namespace drydock::shell
