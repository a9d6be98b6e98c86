#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "drivers/wire/ubx/ubx_nmea.hpp"
#include "estimators/frame/geodetic.hpp"
#include "tests/hil/emulate/bench.hpp"
#include "tests/test_name.hpp"

namespace drydock::emulate {
namespace {

using rig_config::DeviceKind;

template <class Message>
std::vector<Message> all_of(const Recorder& sent) {
  std::vector<Message> found;
  for (const auto& message : sent.messages) {
    const auto decoded = wire::UbxNmea::decode(message.bytes).value();
    if (const auto* m = std::get_if<Message>(&decoded)) found.push_back(*m);
  }
  return found;
}

TEST(EmulatedGnss, NavPvtHoldsTheTruthWithinTheProtocolsResolution) {
  const Frozen trajectory(at_the_surface());
  const auto sent = record(device(DeviceKind::gnss, "ubx"), trajectory, 0.5);
  ASSERT_EQ(sent.messages.size(), 3);
  const auto pvt = all_of<wire::NavPvt>(sent).at(0);
  EXPECT_EQ(pvt.itow, std::chrono::seconds{252818});
  EXPECT_EQ(*pvt.date, std::chrono::year{2023} / 11 / 14);
  EXPECT_EQ(*pvt.time_of_day, std::chrono::seconds{22 * 3600 + 13 * 60 + 20});
  EXPECT_EQ(pvt.fix_type, wire::UbxFixType::three_d);
  EXPECT_TRUE(pvt.fix_ok);
  EXPECT_NEAR(*pvt.latitude_rad, 47.123456 * degree, 1e-7 * degree);
  EXPECT_NEAR(*pvt.longitude_rad, -8.765432 * degree, 1e-7 * degree);
  EXPECT_NEAR(*pvt.ellipsoidal_height_m, -0.1, 1e-3);
  const Eigen::Vector3d v = at_the_surface().velocity_ned;
  EXPECT_NEAR(*pvt.velocity_north_mps, v.x(), 1e-3);
  EXPECT_NEAR(*pvt.velocity_east_mps, v.y(), 1e-3);
  EXPECT_NEAR(*pvt.velocity_down_mps, v.z(), 1e-3);
  EXPECT_NEAR(*pvt.ground_speed_mps, std::hypot(v.x(), v.y()), 1e-3);
  EXPECT_EQ(all_of<wire::NavSat>(sent).at(0).satellites.size(), 10);
  EXPECT_EQ(all_of<wire::NavEoe>(sent).at(0).itow, pvt.itow);
}

TEST(EmulatedGnss, NmeaSentencesHoldTheTruthWithinTheProtocolsResolution) {
  const Frozen trajectory(at_the_surface());
  const auto sent = record(device(DeviceKind::gnss, "nmea0183"), trajectory, 0.5);
  const auto gga = all_of<wire::Gga>(sent).at(0);
  EXPECT_NEAR(*gga.latitude_rad, 47.123456 * degree, 1e-5 / 60 * degree);
  EXPECT_NEAR(*gga.longitude_rad, -8.765432 * degree, 1e-5 / 60 * degree);
  EXPECT_NEAR(*gga.mean_sea_level_height_m, -0.1, 0.005);
  EXPECT_EQ(gga.quality, 1);
  const auto rmc = all_of<wire::Rmc>(sent).at(0);
  const Eigen::Vector3d v = at_the_surface().velocity_ned;
  EXPECT_TRUE(rmc.valid);
  EXPECT_NEAR(*rmc.speed_mps, std::hypot(v.x(), v.y()), 3e-4);
  EXPECT_NEAR(*rmc.course_rad, std::atan2(v.y(), v.x()) + 2 * std::numbers::pi, 1e-4);
  EXPECT_EQ(*rmc.date, std::chrono::year{2023} / 11 / 14);
  EXPECT_EQ(*all_of<wire::Zda>(sent).at(0).time_of_day, std::chrono::seconds{80000});
  EXPECT_EQ(all_of<wire::Gsa>(sent).at(0).fix_type, 3);
  EXPECT_EQ(all_of<wire::Vtg>(sent).size(), 1);
  int satellites = 0;
  for (const auto& gsv : all_of<wire::Gsv>(sent))
    satellites += static_cast<int>(gsv.satellites.size());
  EXPECT_EQ(satellites, 10);
}

TEST(EmulatedGnss, UnderWaterItGoesOnSendingWithoutAFix) {
  const Frozen trajectory(under_way());
  const auto ubx = record(device(DeviceKind::gnss, "ubx"), trajectory, 0.5);
  const auto pvt = all_of<wire::NavPvt>(ubx).at(0);
  EXPECT_EQ(pvt.fix_type, wire::UbxFixType::none);
  EXPECT_FALSE(pvt.fix_ok || pvt.latitude_rad || pvt.velocity_north_mps);
  EXPECT_TRUE(all_of<wire::NavSat>(ubx).at(0).satellites.empty());
  const auto nmea = record(device(DeviceKind::gnss, "nmea0183"), trajectory, 0.5);
  EXPECT_EQ(all_of<wire::Gga>(nmea).at(0).quality, 0);
  EXPECT_FALSE(all_of<wire::Gga>(nmea).at(0).latitude_rad);
  EXPECT_FALSE(all_of<wire::Rmc>(nmea).at(0).valid);
  EXPECT_EQ(all_of<wire::Gsa>(nmea).at(0).fix_type, 1);
  ASSERT_EQ(all_of<wire::Gsv>(nmea).size(), 1);
  EXPECT_EQ(all_of<wire::Gsv>(nmea)[0].satellites_in_view, 0);
}

TEST(EmulatedGnss, EpochsAreWholeMultiplesOfThePeriodInUtc) {
  class Late final : public motion::Trajectory {
   public:
    motion::Truth at(Stamp time) const override { return Frozen(at_the_surface()).at(time); }
    Stamp start() const override { return at_s(0.137); }
    Stamp end() const override { return at_s(0.137); }
  } late;
  const auto sent = record(device(DeviceKind::gnss, "ubx", 5), late, 1);
  const auto pvts = all_of<wire::NavPvt>(sent);
  ASSERT_EQ(pvts.size(), 5);
  EXPECT_EQ(pvts[0].itow, std::chrono::milliseconds{252818200});
  EXPECT_EQ(pvts[4].itow, std::chrono::milliseconds{252819000});
}

TEST(EmulatedGnss, PositionErrorsAreMetresNorthEastDown) {
  const Frozen trajectory(at_the_surface());
  auto config = device(DeviceKind::gnss, "ubx");
  config.emulate.primary.bias = {3, -4, 0};
  const auto pvt = all_of<wire::NavPvt>(record(config, trajectory, 0)).at(0);
  const Eigen::Vector3d offset =
      frame::ned_offset({47.123456 * degree, -8.765432 * degree, -0.1},
                        {*pvt.latitude_rad, *pvt.longitude_rad, *pvt.ellipsoidal_height_m});
  EXPECT_NEAR((offset - Eigen::Vector3d(3, -4, 0)).norm(), 0, 0.02);
  EXPECT_NEAR(*pvt.horizontal_accuracy_m, 5, 1e-3);
}

// The reports of gpsdecode (Debian package gpsd-clients) for a stream, one JSON object each.
std::vector<nlohmann::json> by_gpsdecode(const std::vector<std::uint8_t>& bytes) {
  const auto path = std::filesystem::path(testing::TempDir()) / "drydock-emulated-gnss.bin";
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  std::vector<nlohmann::json> reports;
  FILE* pipe = popen(("/usr/bin/gpsdecode -j < '" + path.string() + "' 2>/dev/null").c_str(), "r");
  std::array<char, 8192> line;
  while (pipe && std::fgets(line.data(), line.size(), pipe)) {
    auto report = nlohmann::json::parse(line.data(), nullptr, false);
    if (!report.is_discarded()) reports.push_back(std::move(report));
  }
  if (pipe) pclose(pipe);
  std::filesystem::remove(path);
  return reports;
}

class GnssWitness : public testing::TestWithParam<const char*> {};

TEST_P(GnssWitness, GpsdReadsTheSamePositionSpeedAndSatellites) {
  if (!std::filesystem::exists("/usr/bin/gpsdecode")) GTEST_SKIP() << "gpsdecode is not installed";
  const Frozen trajectory(at_the_surface());
  const auto sent = record(device(DeviceKind::gnss, GetParam()), trajectory, 5);
  bool position = false, satellites = false;
  for (const auto& report : by_gpsdecode(sent.all_bytes())) {
    if (report.value("class", "") == "TPV" && report.contains("lat")) {
      position = true;
      EXPECT_NEAR(report["lat"].get<double>(), 47.123456, 3e-7);
      EXPECT_NEAR(report["lon"].get<double>(), -8.765432, 3e-7);
      const Eigen::Vector3d v = at_the_surface().velocity_ned;
      if (report.contains("speed")) {
        EXPECT_NEAR(report["speed"].get<double>(), std::hypot(v.x(), v.y()), 2e-3);
      }
    }
    if (report.value("class", "") == "SKY" && report.contains("satellites")) {
      satellites = true;
      EXPECT_EQ(report["satellites"].size(), 10);
    }
  }
  EXPECT_TRUE(position);
  EXPECT_TRUE(satellites);
}

INSTANTIATE_TEST_SUITE_P(Protocols, GnssWitness, testing::Values("ubx", "nmea0183"),
                         [](const auto& one) { return drydock::test::test_name(one.param); });

}  // namespace
}  // namespace drydock::emulate
