#include "hil/sky/orbit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "hil/sky/broadcast_orbits.hpp"
#include "hil/sky/ephemeris_file.hpp"
#include "hil/sky/look.hpp"
#include "tests/hil/sky/files.hpp"

namespace drydock::sky {
namespace orbit_test {

using namespace std::chrono;
using Eigen::Vector3d;

constexpr double pi = M_PI, degree = M_PI / 180;
constexpr double axis_m = 26'560'000;
const GpsTime toe{weeks{2000}};  // second 0 of a week, when the longitude of the node is omega0
GpsTime after(double s) { return toe + measurement::from_seconds(s); }

/// A circle whose node turns with the Earth. In ECEF its plane is fixed.
Ephemeris circle(double radius_m = axis_m) {
  Ephemeris r;
  r.prn = 1;
  r.toc = r.toe = toe;
  r.sqrt_a = std::sqrt(radius_m);
  r.i0_rad = 55 * degree;
  r.omega_dot_radps = gps_earth_rate;
  return r;
}

/// The same orbit in a later broadcast.
Ephemeris circle_at(nanoseconds later) {
  Ephemeris r = circle();
  r.toe += later;
  r.m0_rad = std::sqrt(gps_mu / std::pow(axis_m, 3)) * measurement::seconds(later);
  r.omega0_rad = gps_earth_rate * measurement::seconds(later);  // counts from the week's start
  return r;
}

Ephemeris ellipse() {
  Ephemeris r = circle();
  r.e = 0.02;
  r.m0_rad = 0.3;
  r.omega_rad = -1;
  return r;
}

TEST(Orbit, ACircleIsFlownAtKeplersRate) {
  const double period = 2 * pi * std::sqrt(std::pow(axis_m, 3) / 3.986005e14);
  for (int i = 0; i <= 12; ++i) {
    const double u = i * pi / 6;
    const auto at = satellite_at(circle(), after(period * i / 12)).ecef_m;
    const Vector3d expected = axis_m * Vector3d{std::cos(u), std::sin(u) * std::cos(55 * degree),
                                                std::sin(u) * std::sin(55 * degree)};
    EXPECT_LT((at - expected).norm(), 1e-4) << i;  // an error of 1 ns in the period is 4 um along
                                                   // the orbit
  }
}

TEST(Orbit, WithoutPrecessionTheNodeGoesWestAsTheEarthTurnsEast) {
  Ephemeris r = circle();
  r.omega_dot_radps = 0;
  const double half_period = pi * std::sqrt(std::pow(axis_m, 3) / 3.986005e14);
  const auto at = satellite_at(r, after(half_period)).ecef_m;  // the descending node
  const double longitude = pi - 7.2921151467e-5 * half_period;
  EXPECT_NEAR(at.x(), axis_m * std::cos(longitude), 1e-3);
  EXPECT_NEAR(at.y(), axis_m * std::sin(longitude), 1e-3);
  EXPECT_NEAR(at.z(), 0, 1e-3);
}

TEST(Orbit, TheRadiusSweepsEqualAreasBetweenPerigeeAndApogee) {
  const Ephemeris r = ellipse();
  const double areas = std::sqrt(3.986005e14 * axis_m * (1 - r.e * r.e));
  double nearest = 1e9, farthest = 0;
  for (double t = 0; t < 43200; t += 60) {
    const Vector3d p = satellite_at(r, after(t)).ecef_m;
    const Vector3d v =
        (satellite_at(r, after(t + 1)).ecef_m - satellite_at(r, after(t - 1)).ecef_m) / 2;
    EXPECT_NEAR(p.cross(v).norm() / areas, 1, 1e-8) << t;
    nearest = std::min(nearest, p.norm());
    farthest = std::max(farthest, p.norm());
  }
  EXPECT_NEAR(nearest, axis_m * 0.98, 20);
  EXPECT_NEAR(farthest, axis_m * 1.02, 20);
}

TEST(Orbit, HarmonicsMoveItAlongOutAndAcross) {
  Ephemeris r = circle();
  r.m0_rad = pi / 8;  // sin 2u = cos 2u
  const Vector3d plain = satellite_at(r, toe).ecef_m;
  const Vector3d out = plain.normalized();
  const Vector3d across{0, -std::sin(55 * degree), std::cos(55 * degree)};
  const Vector3d along = across.cross(out);
  const auto moved = [&](auto change) {
    Ephemeris with = r;
    change(with);
    return Vector3d(satellite_at(with, toe).ecef_m - plain);
  };
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(moved([](auto& x) { x.crs_m = 10; }).dot(out), 10 * half, 1e-6);
  EXPECT_NEAR(moved([](auto& x) { x.crc_m = 10; }).dot(out), 10 * half, 1e-6);
  EXPECT_NEAR(moved([](auto& x) { x.cus_rad = 1e-6; }).dot(along), 26.56 * half, 1e-4);
  EXPECT_NEAR(moved([](auto& x) { x.cuc_rad = 1e-6; }).dot(along), 26.56 * half, 1e-4);
  const double lever = 26.56 * std::sin(pi / 8);  // the rotation is about the line of nodes
  EXPECT_NEAR(moved([](auto& x) { x.cis_rad = 1e-6; }).dot(across), lever * half, 1e-4);
  EXPECT_NEAR(moved([](auto& x) { x.cic_rad = 1e-6; }).dot(across), lever * half, 1e-4);
}

TEST(Clock, RelativityIsMinusTwiceRadiusTimesVelocityOverLightSpeedSquared) {
  const Ephemeris r = ellipse();
  for (double t = 0; t < 43200; t += 3600) {
    const Vector3d p = satellite_at(r, after(t)).ecef_m;
    const Vector3d v =
        (satellite_at(r, after(t + 1)).ecef_m - satellite_at(r, after(t - 1)).ecef_m) / 2;
    const double identity = -2 * p.dot(v) / std::pow(299792458.0, 2);  // IS-GPS-200, 20.3.3.3.3.1
    EXPECT_NEAR(satellite_at(r, after(t)).relativity_s, identity, 1e-14) << t;
  }
}

TEST(Clock, IsThePolynomialOfTheTimeSinceToc) {
  Ephemeris r = circle();
  r.toc = toe - 100s;
  r.af0_s = 1e-4, r.af1 = 2e-11, r.af2_ps = 3e-18;
  EXPECT_NEAR(satellite_at(r, after(900)).clock_s, 1e-4 + 2e-8 + 3e-12, 1e-18);
}

TEST(Look, GeometryIsThatOfARightTriangleInTheEquatorsPlane) {
  // Directly above the point; from 60 deg further east, it is in the west.
  Ephemeris r = circle();
  const Look above = look_at(r, toe, {0, 0, 0});
  EXPECT_NEAR(above.elevation_rad, 90 * degree, 1e-4);
  EXPECT_NEAR(above.range_m, axis_m - 6378137, 50);
  const Look west = look_at(r, toe, {0, 60 * degree, 0});
  const double elevation = std::atan2(0.5 - 6378137 / axis_m, std::sin(60 * degree));
  EXPECT_NEAR(west.elevation_rad, elevation, 2e-5);  // the satellite flew 260 m during the signal's
                                                     // flight
  EXPECT_NEAR(west.azimuth_rad, 270 * degree, 2e-5);
  EXPECT_NEAR(look_at(r, toe, {0, -60 * degree, 0}).azimuth_rad, 90 * degree, 2e-5);
  EXPECT_LT(look_at(r, toe, {0, pi, 0}).elevation_rad, -80 * degree);
}

TEST(Look, TheEarthTurnsUnderTheSignal) {
  // A satellite that is fixed in ECEF appears further away by omega (x_s y_r - y_s x_r) / c
  // (Sagnac).
  const double resting_m = std::cbrt(gps_mu / (gps_earth_rate * gps_earth_rate));
  Ephemeris r = circle(resting_m);
  r.i0_rad = 0;
  r.omega_dot_radps = 0;
  ASSERT_LT((satellite_at(r, after(1000)).ecef_m - Vector3d{resting_m, 0, 0}).norm(), 1e-3);
  const double l = 60 * degree, radius = 6378137;
  const double distance =
      std::sqrt(resting_m * resting_m + radius * radius - 2 * resting_m * radius * std::cos(l));
  const double sagnac = gps_earth_rate * resting_m * radius * std::sin(l) / 299792458;
  EXPECT_NEAR(sagnac, 56.7, 0.1);
  EXPECT_NEAR(look_at(r, toe, {0, l, 0}).range_m, distance + sagnac, 0.01);
  EXPECT_NEAR(look_at(r, toe, {0, -l, 0}).range_m, distance - sagnac, 0.01);
}

TEST(WalkerFixture, EverySatelliteIsWhereItsNoteSays) {
  const BroadcastOrbits orbits(read_navigation_file(test::walker()).value().records);
  for (int n = 1; n <= 24; ++n) {
    const int plane = (n - 1) / 4, slot = (n - 1) % 4;
    const double u = (90 * slot + 15 * plane) * degree, node = 60 * plane * degree;
    const double across = std::sin(u) * std::cos(55 * degree);
    const Vector3d expected =
        26'559'710 * Vector3d{std::cos(u) * std::cos(node) - across * std::sin(node),
                              std::cos(u) * std::sin(node) + across * std::cos(node),
                              std::sin(u) * std::sin(55 * degree)};
    const Ephemeris* record = orbits.nearest(n, test::walker_toe);
    ASSERT_NE(record, nullptr) << n;
    const SatelliteState state = satellite_at(*record, test::walker_toe);
    EXPECT_LT((state.ecef_m - expected).norm(), 1e-3) << n;
    EXPECT_NEAR(state.clock_s, n * 1e-6, 1e-15);
  }
}

TEST(Choice, IsTheNearestHealthyToeWithinTwoHours) {
  const Ephemeris early = circle(), late = circle_at(2h);
  Ephemeris ill = circle_at(1h);
  ill.health = 63;
  const BroadcastOrbits orbits({late, ill, early});
  const auto toe_at = [&](nanoseconds t) { return orbits.nearest(1, toe + t)->toe - toe; };
  EXPECT_EQ(toe_at(-2h), 0s);
  EXPECT_EQ(toe_at(1h), 0s);  // both are equally near: the earlier
  EXPECT_EQ(toe_at(1h + 1ns), 2h);
  EXPECT_EQ(toe_at(4h), 2h);
  EXPECT_EQ(orbits.nearest(1, toe + 4h + 1ns), nullptr);
  EXPECT_EQ(orbits.nearest(1, toe - 2h - 1ns), nullptr);
  EXPECT_EQ(orbits.nearest(2, toe), nullptr);
  EXPECT_EQ(orbits.nearest(1, toe + 1h, BroadcastOrbits::Health::any)->health, 63U);
}

TEST(Choice, AnAbsurdOrbitIsRefusedWhateverItsHealth) {
  const auto why = [](auto change) {
    Ephemeris r = circle();
    change(r);
    return absurd(r).value_or("sound");
  };
  EXPECT_EQ(why([](auto&) {}), "sound");
  EXPECT_THAT(why([](auto& r) { r.sqrt_a = std::sqrt(40e6); }),
              testing::HasSubstr("semi-major axis 40000 km"));
  EXPECT_THAT(why([](auto& r) { r.sqrt_a = NAN; }), testing::HasSubstr("semi-major axis"));
  EXPECT_THAT(why([](auto& r) { r.e = 0.031; }), testing::HasSubstr("eccentricity 0.031"));
  EXPECT_THAT(why([](auto& r) { r.i0_rad = 0; }), testing::HasSubstr("inclination 0.0 deg"));
  EXPECT_THAT(why([](auto& r) { r.crc_m = 3e6; }),
              testing::HasSubstr("km from the Earth's centre"));
  const BroadcastOrbits orbits(read_navigation_file(test::walker()).value().records);
  ASSERT_EQ(orbits.refused().size(), 1);
  EXPECT_EQ(orbits.refused()[0].record.prn, 26);
  EXPECT_EQ(orbits.nearest(26, test::walker_toe), nullptr);
  EXPECT_EQ(orbits.nearest(25, test::walker_toe), nullptr);  // unhealthy
  EXPECT_EQ(orbits.usable(test::walker_toe), 24);
}

TEST(Choice, ARecordOfAnotherSatelliteIsRefusedByItsNeighboursVote) {
  std::vector<Ephemeris> records;
  for (int i = 0; i < 5; ++i) {
    records.push_back(circle_at(i * 2h));
    records.back().health = 63;
  }
  EXPECT_TRUE(BroadcastOrbits(records).refused().empty());
  records[2].omega0_rad += 1;
  records[2].health = 0;
  const BroadcastOrbits orbits(records);
  ASSERT_EQ(orbits.refused().size(), 1);
  EXPECT_EQ(orbits.refused()[0].record.toe, toe + 4h);
  EXPECT_THAT(orbits.refused()[0].why, testing::HasSubstr("(4 against, 0 for)"));
  EXPECT_EQ(orbits.nearest(1, toe + 4h), nullptr);
}

}  // namespace orbit_test
}  // namespace drydock::sky
