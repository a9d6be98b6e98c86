#include <gmock/gmock.h>

#include <filesystem>
#include <numbers>

#include "rig_config/load.hpp"

namespace drydock::rig_config {
namespace {

namespace fs = std::filesystem;
constexpr double pi = std::numbers::pi;
const std::string folder = DRYDOCK_SOURCE_DIR "/rig_config/";

class DemoRig : public testing::Test {
 protected:
  const DeviceConfig& device(std::string_view name) const {
    for (const DeviceConfig& device : rig_.devices)
      if (device.name == name) return device;
    throw std::out_of_range("no such device in demo.toml");
  }
  const Rig rig_ = load_rig(folder + "rigs/demo.toml").value();
};

TEST(ShippedFiles, EveryOneIsSound) {
  int files = 0;
  for (const char* part : {"rigs", "missions", "sensors", "vehicles"})
    for (const auto& entry : fs::directory_iterator(folder + part)) {
      for (const Problem& problem : check_file(entry.path())) ADD_FAILURE() << to_string(problem);
      ++files;
    }
  EXPECT_GE(files, 7);
}

TEST_F(DemoRig, StartsAtTheWrittenInstant) {
  EXPECT_EQ(rig_.start_utc_ns, 1'795'248'000'000'000'000);  // date -u -d 2026-11-21T08:00:00Z +%s
}

TEST(Start, AnOffsetIsTakenIntoAccount) {
  const auto rig = load_rig_text(
      "[rig]\nname = \"r\"\nstart = 2026-11-21T17:30:00.25+09:30\n"
      "[[device]]\nname = \"d\"\nkind = \"dvl\"\nprotocol = \"pd0\"\nlink = \"pty:d\"\n",
      "r.toml");
  EXPECT_EQ(rig.value().start_utc_ns, 1'795'248'000'250'000'000);
}

TEST_F(DemoRig, HasSixDevicesOneOfEachKind) {
  std::vector<DeviceKind> kinds;
  for (const DeviceConfig& d : rig_.devices) kinds.push_back(d.kind);
  EXPECT_THAT(kinds, testing::UnorderedElementsAre(DeviceKind::dvl, DeviceKind::emlog,
                                                   DeviceKind::gnss, DeviceKind::imu,
                                                   DeviceKind::depth, DeviceKind::actuator));
}

TEST_F(DemoRig, SensorErrorsAreThoseOfTheLevelingPaper) {
  const EmulateConfig& imu = device("imu").emulate;
  const EmulateConfig& log = device("emlog").emulate;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(imu.primary.bias[axis], 4.848136811095360e-6, 1e-20);   // 1 deg/h
    EXPECT_NEAR(imu.primary.noise[axis], 1.454441043328608e-6, 1e-20);  // 0.3 deg/h
    EXPECT_NEAR(imu.secondary.bias[axis], 9.80665e-3, 1e-17);           // 1 mg
    EXPECT_NEAR(imu.secondary.noise[axis], 4.903325e-4, 1e-17);         // 50 ug
    EXPECT_DOUBLE_EQ(log.primary.bias[axis], 0.1);
    EXPECT_DOUBLE_EQ(log.primary.noise[axis], 0.1);
  }
  EXPECT_TRUE(imu.fixed_bias);
}

TEST_F(DemoRig, AnglesAreRadiansAndMillisecondsSeconds) {
  EXPECT_DOUBLE_EQ(device("dvl").mounting_rad[2], pi / 4);
  EXPECT_DOUBLE_EQ(device("imu").mounting_rad[0], pi);
  EXPECT_DOUBLE_EQ(device("gnss").emulate.latency_s, 0.04);
  EXPECT_DOUBLE_EQ(rig_.mission.latitude_rad, pi / 5);
  EXPECT_DOUBLE_EQ(rig_.mission.longitude_rad, 129 * pi / 180);
  EXPECT_DOUBLE_EQ(std::get<LevelingConfig>(rig_.estimators.at(0).kind).start.latitude_rad, pi / 5);
}

TEST_F(DemoRig, MissionCoversEveryKindOfLegAndEndsAtTheDepthItBeganAt) {
  std::vector<LegKind> kinds;
  double depth_m = rig_.mission.depth_m;
  for (const LegConfig& leg : rig_.mission.legs) {
    kinds.push_back(leg.kind);
    depth_m += leg.depth_change_m;
  }
  for (LegKind kind : {LegKind::straight, LegKind::turn, LegKind::dive, LegKind::s_path})
    EXPECT_THAT(kinds, testing::Contains(kind));
  EXPECT_EQ(rig_.mission.depth_m, 0);
  EXPECT_EQ(depth_m, 0);
  EXPECT_DOUBLE_EQ(rig_.mission.legs.at(1).amplitude_rad, pi / 4);
  EXPECT_DOUBLE_EQ(rig_.mission.legs.at(1).period_s, 30);
}

TEST_F(DemoRig, ALegWithoutASpeedKeepsTheOneBefore) {
  EXPECT_EQ(rig_.mission.legs.at(3).speed_mps, 3.0);
  EXPECT_EQ(rig_.mission.legs.at(4).speed_mps, 2.5);
  EXPECT_EQ(rig_.mission.legs.at(5).speed_mps, 2.5);
}

TEST_F(DemoRig, TheLinesCarryWhatTheDevicesSay) {
  // 10 bits per byte: UBX NAV-PVT (100 bytes), NAV-SAT of ten satellites (136) and NAV-EOE (12).
  EXPECT_LT((100 + 136 + 12) * 10 * device("gnss").rate_hz, 38400);
  // Two NMEA 0183 sentences of at most 82 characters.
  EXPECT_LT(2 * 82 * 10 * device("emlog").rate_hz, 4800);
  // CAN at 250 kbit/s: a 29-bit data frame of 8 bytes is at most 160 bits with stuffing.
  EXPECT_LT(160 * (3 * device("imu").rate_hz + 2 * device("depth").rate_hz +
                   4 * device("actuators").rate_hz),
            250'000);
}

TEST(ReplayedGps, TheRecordingIsFoundFromTheRigFilesFolder) {
  const Rig rig = load_rig(folder + "rigs/replayed-gps.toml").value();
  const auto gnss = std::ranges::find(rig.devices, DeviceKind::gnss, &DeviceConfig::kind);
  ASSERT_NE(gnss, rig.devices.end());
  const fs::path expected = fs::path(DRYDOCK_SOURCE_DIR).parent_path() /
                            "shared/corpora/gps/gpsd/daemon/ublox-neo-m8l.log";
  EXPECT_EQ(gnss->link, "file:" + expected.string() + "?speed=1&baud=38400");
}

TEST(Links, OnlyRelativeFileTargetsAreResolved) {
  const auto link_of = [](const std::string& link) {
    return load_rig_text(
               "[rig]\nname = \"r\"\n[[device]]\nname = \"d\"\nkind = \"dvl\"\n"
               "protocol = \"pd0\"\nlink = \"" +
                   link + "\"\n",
               "/a/b/r.toml")
        .value()
        .devices.at(0)
        .link;
  };
  EXPECT_EQ(link_of("file:../x.cap?speed=max"), "file:/a/x.cap?speed=max");
  EXPECT_EQ(link_of("file:x.cap"), "file:/a/b/x.cap");
  EXPECT_EQ(link_of("file:/x.cap"), "file:/x.cap");
  EXPECT_EQ(link_of("pty:../x"), "pty:../x");
}

TEST(Emulate, ItsOwnKeysOverrideTheSensorFile) {
  const auto rig = load_rig_text(
      "[rig]\nname = \"r\"\n[[device]]\nname = \"i\"\nkind = \"imu\"\nprotocol = \"cia404-imu\"\n"
      "link = \"can:auto\"\naddress = 1\nemulate = { errors = \"../sensors/leveling-paper.toml\", "
      "gyro_bias_degph = [3600, 0, -7200] }\n",
      folder + "rigs/r.toml");
  const EmulateConfig& imu = rig.value().devices.at(0).emulate;
  EXPECT_DOUBLE_EQ(imu.primary.bias[0], pi / 180);
  EXPECT_DOUBLE_EQ(imu.primary.bias[1], 0);
  EXPECT_DOUBLE_EQ(imu.primary.bias[2], -pi / 90);
  EXPECT_NEAR(imu.secondary.bias[2], 9.80665e-3, 1e-17);
}

TEST(ImuSettings, AreReadFromTheirTables) {
  const auto rig = load_rig_text(
      "[rig]\nname = \"r\"\n"
      "[[device]]\nname = \"a\"\nkind = \"imu\"\nprotocol = \"aceinna\"\nlink = \"can:auto\"\n"
      "[device.aceinna]\npacket_rate_hz = 50\nslope_message = \"off\"\nrate_filter_hz = 25\n"
      "acceleration_filter_hz = 0\norientation = \"-X-Y+Z\"\n"
      "[[device]]\nname = \"x\"\nkind = \"imu\"\nprotocol = \"xsens\"\nlink = \"can:auto\"\n"
      "xsens = { extended = true, identifiers = { rate_of_turn = 0x19FF0032 } }\n"
      "[[device]]\nname = \"e\"\nkind = \"imu\"\nprotocol = \"epson-g552\"\nlink = \"can:auto\"\n"
      "rate_hz = 125\nsync = true\nheartbeat_timeout_s = 1.5\naddress = 2\n"
      "[[device]]\nname = \"p\"\nkind = \"actuator\"\nprotocol = \"nmea2000\"\nlink = "
      "\"can:auto\"\n"
      "instance = 1\n",
      folder + "rigs/r.toml");
  ASSERT_TRUE(rig);
  const AceinnaConfig& aceinna = rig->devices.at(0).aceinna;
  EXPECT_EQ(aceinna.packet_rate_hz, 50);
  EXPECT_EQ(aceinna.slope_message, "off");
  EXPECT_EQ(aceinna.rate_filter_hz, 25);
  EXPECT_EQ(aceinna.acceleration_filter_hz, 0);
  EXPECT_EQ(aceinna.orientation, "-X-Y+Z");
  const XsensConfig& xsens = rig->devices.at(1).xsens;
  EXPECT_TRUE(xsens.extended);
  ASSERT_EQ(xsens.identifiers.size(), 1U);
  EXPECT_EQ(xsens.identifiers[0].message, "rate_of_turn");
  EXPECT_EQ(xsens.identifiers[0].id, 0x19FF0032U);
  EXPECT_TRUE(rig->devices.at(2).sync);
  EXPECT_EQ(rig->devices.at(2).heartbeat_timeout_s, 1.5);
  EXPECT_EQ(rig->devices.at(3).instance, 1);
  EXPECT_FALSE(rig->devices.at(2).instance);
}

}  // namespace
}  // namespace drydock::rig_config
