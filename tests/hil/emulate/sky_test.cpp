// The satellites of a broadcast file, read from the wire of an emulated receiver.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "drivers/wire/ubx/ubx_nmea.hpp"
#include "hil/sky/broadcast_sky.hpp"
#include "hil/sky/ephemeris_file.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace sky_test {

using testing::HasSubstr;

const std::string walker = DRYDOCK_SOURCE_DIR "/fixtures/rinex/walker.rnx";

/// 2026-11-21T09:00:00Z: an hour before the file's toe.
const Stamp sky_start = measurement::stamp_from_ns(1'795'251'600'000'000'000);

class Surfaced final : public motion::Trajectory {
 public:
  explicit Surfaced(double roll_deg = 0) : truth_(at_the_surface()) {
    truth_.latitude_rad = 36 * degree;
    truth_.longitude_rad = 129 * degree;
    truth_.body_to_ned = frame::body_to_ned({roll_deg * degree, 0, 0});
  }
  motion::Truth at(Stamp time) const override {
    motion::Truth truth = truth_;
    truth.at = time;
    return truth;
  }
  Stamp start() const override { return sky_start; }
  Stamp end() const override { return sky_start; }

 private:
  motion::Truth truth_;
};

rig_config::DeviceConfig receiver(const std::string& protocol) {
  auto config = device(rig_config::DeviceKind::gnss, protocol);
  config.emulate.sky.emplace().ephemeris = walker;
  return config;
}

template <class Message>
std::vector<Message> sent_by(const rig_config::DeviceConfig& config, const Surfaced& trajectory) {
  Recorder recorder;
  const auto made = make_emulated_device(config, trajectory, 1).value();
  recorder.run(*made, sky_start + std::chrono::milliseconds{500});
  std::vector<Message> found;
  for (const auto& message : recorder.messages) {
    const auto decoded = wire::UbxNmea::decode(message.bytes).value();
    if (const auto* m = std::get_if<Message>(&decoded)) found.push_back(*m);
  }
  return found;
}

measurement::GnssSatellites expected(const Surfaced& trajectory) {
  const auto config = receiver("ubx");
  sky::BroadcastSky sky(sky::BroadcastOrbits(sky::read_navigation_file(walker).value().records),
                        *config.emulate.sky, sky_start, 1, config.name);
  return sky.at(trajectory.at(sky_start));
}

TEST(EmulatedSky, UbxReportsTheFilesSatellitesWithDirectionsAndSignal) {
  const Surfaced trajectory;
  const auto truth = expected(trajectory).satellites;
  const auto told = sent_by<wire::NavSat>(receiver("ubx"), trajectory).at(0).satellites;
  ASSERT_EQ(told.size(), truth.size());
  ASSERT_GE(told.size(), 6);
  for (std::size_t i = 0; i < told.size(); ++i) {
    EXPECT_EQ(told[i].number, truth[i].number);
    EXPECT_NEAR(*told[i].elevation_rad, *truth[i].elevation_rad, 0.51 * degree);
    EXPECT_NEAR(*told[i].azimuth_rad, *truth[i].azimuth_rad, 0.51 * degree);
    EXPECT_EQ(told[i].cno_dbhz, truth[i].cno_dbhz);
    EXPECT_EQ(told[i].used, truth[i].used);
  }
  EXPECT_EQ(sent_by<wire::NavPvt>(receiver("ubx"), trajectory).at(0).fix_type,
            wire::UbxFixType::three_d);
}

TEST(EmulatedSky, Nmea0183ReportsTheSameSatellites) {
  const Surfaced trajectory;
  const auto truth = expected(trajectory).satellites;
  std::size_t i = 0;
  for (const auto& gsv : sent_by<wire::Gsv>(receiver("nmea0183"), trajectory)) {
    EXPECT_EQ(gsv.satellites_in_view, static_cast<int>(truth.size()));
    for (const auto& told : gsv.satellites) {
      ASSERT_LT(i, truth.size());
      EXPECT_EQ(told.number, truth[i].number);
      EXPECT_NEAR(*told.elevation_rad, *truth[i].elevation_rad, 0.51 * degree);
      EXPECT_NEAR(*told.azimuth_rad, *truth[i].azimuth_rad, 0.51 * degree);
      EXPECT_EQ(told.cno_dbhz, truth[i].cno_dbhz);
      ++i;
    }
  }
  EXPECT_EQ(i, truth.size());
}

TEST(EmulatedSky, RollingTurnsTheSignalByTheAntennasPattern) {
  const auto upright = sent_by<wire::NavSat>(receiver("ubx"), Surfaced(0)).at(0).satellites;
  const auto heeled = sent_by<wire::NavSat>(receiver("ubx"), Surfaced(90)).at(0).satellites;
  ASSERT_EQ(upright.size(), heeled.size());
  // After a roll of +90 deg the antenna points to starboard, which is east. Satellites in the west
  // become weak.
  for (std::size_t i = 0; i < upright.size(); ++i) {
    const double east = std::sin(*upright[i].azimuth_rad) * std::cos(*upright[i].elevation_rad);
    const double up = std::sin(*upright[i].elevation_rad);
    const double before = upright[i].cno_dbhz.value_or(0), after = heeled[i].cno_dbhz.value_or(0);
    if (east > up + 0.05) {
      EXPECT_GE(after, before) << i;
    } else if (east < up - 0.05) {
      EXPECT_LE(after, before) << i;
    }
  }
}

TEST(EmulatedSky, WithFewerThanFourSatellitesThereIsNoFix) {
  auto config = receiver("ubx");
  config.emulate.sky->lowest_cno_dbhz = 47.5;  // hardly any satellite is so close to boresight
  const Surfaced trajectory;
  const auto pvt = sent_by<wire::NavPvt>(config, trajectory).at(0);
  EXPECT_EQ(pvt.fix_type, wire::UbxFixType::none);
  EXPECT_LT(pvt.satellites_used, 4);
  EXPECT_FALSE(pvt.latitude_rad);
  EXPECT_FALSE(sent_by<wire::NavSat>(config, trajectory).at(0).satellites.empty());
}

TEST(EmulatedSky, AFileOfAnotherDayIsRefusedWithItsDays) {
  const Frozen years_before(at_the_surface());
  const auto made = make_emulated_device(receiver("ubx"), years_before, 1);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message,
              HasSubstr("at 2023-11-14T22:13:38 GPS no satellite has a healthy record within 2 h"));
  EXPECT_THAT(made.error().message, HasSubstr("2026-11-21T10:00:00 GPS"));
}

TEST(EmulatedSky, ButMayBeTakenAsTheSkyOfThen) {
  const Frozen years_before(at_the_surface());
  auto config = receiver("ubx");
  config.emulate.sky->at_utc_ns = sky_start.time_since_epoch().count();
  EXPECT_TRUE(make_emulated_device(config, years_before, 1));
}

TEST(EmulatedSky, ABadFileIsToldWithItsLine) {
  const Surfaced trajectory;
  auto config = receiver("nmea0183");
  config.emulate.sky->ephemeris = DRYDOCK_SOURCE_DIR "/README.md";
  const auto made = make_emulated_device(config, trajectory, 1);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("README.md:1: no RINEX file"));
}

}  // namespace sky_test
}  // namespace drydock::emulate
