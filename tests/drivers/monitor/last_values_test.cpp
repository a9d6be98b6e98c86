#include "drivers/monitor/values/last_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace last_values_test {

using namespace drydock;
using measurement::Origin;
using monitor::LastValues;

Origin at(double s, std::uint16_t device = 0) {
  Origin origin;
  origin.device = device;
  origin.valid_at = origin.received_at = measurement::Stamp{measurement::from_seconds(s)};
  return origin;
}

std::string text_of(const LastValues& all, const std::string& name, std::uint16_t device = 0) {
  for (const auto& value : all.values(device, {}))
    if (value.name == name) return value.full();
  return "none";
}

TEST(LastValues, ALogThatSendsSpeedAndDistanceInTwoSentencesShowsBoth) {
  LastValues all;
  measurement::WaterSpeed speed{.origin = at(1),
                                .longitudinal_mps = 2.5,
                                .transverse_mps = {},
                                .distance_m = {},
                                .sigma_mps = {}};
  measurement::WaterSpeed distance{.origin = at(1.1),
                                   .longitudinal_mps = {},
                                   .transverse_mps = {},
                                   .distance_m = 1852,
                                   .sigma_mps = {}};
  all.on_measurement(speed);
  all.on_measurement(distance);
  EXPECT_EQ(text_of(all, "longitudinal"), "2.500 m/s");
  EXPECT_EQ(text_of(all, "distance"), "1852.000 m");
}

TEST(LastValues, RudderAndPropellerOfTwoMessagesAreBothThere) {
  LastValues all;
  measurement::ActuatorState rudder, propeller;
  rudder.origin = at(1, 3);
  rudder.rudder_rad = M_PI / 18;
  propeller.origin = at(2, 3);
  propeller.propeller_radps = 2 * M_PI;
  all.on_measurement(rudder);
  all.on_measurement(propeller);
  EXPECT_EQ(text_of(all, "rudder", 3), "10.000 deg");
  EXPECT_EQ(text_of(all, "propeller", 3), "60.00 r/min");
  EXPECT_EQ(text_of(all, "rudder", 0), "none");
}

TEST(LastValues, AValueThatNoLongerComesSaysHowOldItIs) {
  LastValues all;
  measurement::BottomVelocity locked, lost;
  locked.origin = at(10);
  locked.velocity = Eigen::Vector3d(1, 0.5, -0.25);
  lost.origin = at(22);
  lost.altitude_m = 60;
  all.on_measurement(locked);
  all.on_measurement(lost);
  EXPECT_EQ(text_of(all, "velocity"), "1.000 0.500 -0.250 m/s (12 s ago)");
  EXPECT_EQ(text_of(all, "altitude"), "60.000 m");
}

TEST(LastValues, EverySatelliteHasItsOwnLine) {
  LastValues all;
  measurement::GnssSatellites sky;
  sky.origin = at(1);
  sky.satellites.push_back({measurement::Constellation::galileo, 11, 45.0, M_PI / 6, M_PI, true});
  all.on_measurement(sky);
  EXPECT_EQ(text_of(all, "galileo 11"),
            "cno 45.0 dBHz  elevation 30.000 deg  azimuth 180.000 deg  used");
}

TEST(LastValues, AFixIsAWordAndAPlaceHasSevenDecimals) {
  LastValues all;
  measurement::GnssFix fix;
  fix.origin = at(1);
  fix.type = measurement::FixType::three_d;
  fix.quality = measurement::FixQuality::rtk_fixed;
  fix.position = measurement::Geodetic{M_PI / 5, -M_PI / 3};
  all.on_measurement(fix);
  EXPECT_EQ(text_of(all, "fix"), "3D");
  EXPECT_EQ(text_of(all, "quality"), "RTK fixed");
  EXPECT_EQ(text_of(all, "latitude"), "36.0000000 deg");
  EXPECT_EQ(text_of(all, "longitude"), "-60.0000000 deg");
}

}  // namespace last_values_test
