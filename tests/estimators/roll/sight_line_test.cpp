#include "estimators/roll/sight_line.hpp"

#include <gtest/gtest.h>

#include "estimators/roll/antenna.hpp"
#include "tests/estimators/roll/flight.hpp"

namespace drydock::roll::sight_line_test {
namespace {

using test::degree;

TEST(FlightPath, PitchIsTheAngleAboveTheHorizonNotThatFromNadir) {
  const auto up = flight_path({30, 40, -50});  // 50 m/s over ground, 50 m/s up
  EXPECT_NEAR(up.pitch_rad, 45 * degree, 1e-12);
  EXPECT_NEAR(up.azimuth_rad, std::atan2(4, 3), 1e-12);
  EXPECT_NEAR(flight_path({10, 0, 10}).pitch_rad, -45 * degree, 1e-12);
}

TEST(AzimuthOfPoint, IsThatOfTheGreatCircleOnBothSides) {
  EXPECT_NEAR(azimuth_of_point(0, 0, 0, 0.1), 90 * degree, 1e-12);
  EXPECT_NEAR(azimuth_of_point(0, 0, 0, -0.1), -90 * degree, 1e-12);
  EXPECT_NEAR(azimuth_of_point(0, 0, 0.1, 0), 0, 1e-12);
  // Napier's rule: in a right spherical triangle with legs a (along the equator) and b,
  // tan A = tan b / sin a.
  const double a = 0.4, b = 0.3;
  EXPECT_NEAR(azimuth_of_point(0, 0, b, a), 90 * degree - std::atan(std::tan(b) / std::sin(a)),
              1e-12);
  EXPECT_NEAR(azimuth_of_point(0, 0, b, -a), -azimuth_of_point(0, 0, b, a), 1e-12);
}

TEST(SightLine, OverheadOnALevelFlightIsStrongestUpsideDown) {
  const SightLine zenith({0, 0, -1}, {1.2, 0}, {0, 0, 1});
  EXPECT_NEAR(zenith.sin_elevation(0), -1, 1e-12);
  EXPECT_NEAR(std::abs(zenith.strongest_roll()), 180 * degree, 1e-12);
}

TEST(SightLine, ASatelliteAbeamToStarboardIsStrongestWithTheAntennaTurnedToIt) {
  // The heading is north, and at roll 0 the antenna points down. A roll to port (negative) by 90
  // deg turns the antenna to starboard.
  const SightLine east({0, 1, 0}, {0, 0}, {0, 0, 1});
  EXPECT_NEAR(east.strongest_roll(), -90 * degree, 1e-12);
  EXPECT_NEAR(east.sin_elevation(-90 * degree), 1, 1e-12);
}

TEST(SightLine, AgreesWithTheFullRotationAtAnyAttitude) {
  const Eigen::Vector3d toward = toward_ned(35 * degree, 210 * degree);
  EXPECT_NEAR(toward.z(), -std::sin(35 * degree), 1e-12);
  EXPECT_LT(toward.y(), 0);
  const Eigen::Vector3d boresight = Eigen::Vector3d{0.2, -0.5, 0.8}.normalized();
  for (double roll = -3; roll < 3; roll += 0.37) {
    const SightLine line(toward, {0.7, -0.4}, boresight);
    const Eigen::Vector3d body = frame::ned_to_body({roll, -0.4, 0.7}) * toward;
    EXPECT_NEAR(line.sin_elevation(roll), boresight.dot(body), 1e-12);
    EXPECT_NEAR(line.slope(roll),
                (line.sin_elevation(roll + 1e-6) - line.sin_elevation(roll - 1e-6)) / 2e-6, 1e-8);
    EXPECT_LE(line.sin_elevation(roll), line.sin_elevation(line.strongest_roll()) + 1e-12);
  }
}

TEST(Antenna, HasThePapersPattern) {
  // Figures of the acceptance notes: -8.4 dB at 90 deg off boresight, -33.7 dB behind.
  const AntennaOptions antenna;
  const SightLine zenith({0, 0, -1}, {0, 0}, {0, 0, 1});
  const auto db = [&](double roll) {
    return 10 * std::log10(power_of(antenna, zenith, roll).value);
  };
  EXPECT_NEAR(db(180 * degree), 0, 1e-9);
  EXPECT_NEAR(db(90 * degree), -8.4, 0.05);
  EXPECT_NEAR(db(0), -33.7, 0.05);
}

TEST(Antenna, SlopeIsTheDerivativeAlsoAtBoresightAndBehind) {
  const AntennaOptions antenna;
  for (const double elevation : {90.0, 60.0, 5.0}) {
    const SightLine line(toward_ned(elevation * degree, 0.3), {0.1, 0.2}, {0, 0, 1});
    for (double roll = -3.1; roll < 3.2; roll += 0.1) {
      const double up = power_of(antenna, line, roll + 1e-6).value;
      const double down = power_of(antenna, line, roll - 1e-6).value;
      EXPECT_NEAR(power_of(antenna, line, roll).slope, (up - down) / 2e-6, 1e-6);
    }
  }
}

}  // namespace
}  // namespace drydock::roll::sight_line_test
