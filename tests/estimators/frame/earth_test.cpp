#include "estimators/frame/earth.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "estimators/frame/geodetic.hpp"

namespace drydock::frame {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double arc_degree = std::numbers::pi / 180;

TEST(Earth, DerivedConstantsAreThoseOfTr8350_2Table3_3) {
  EXPECT_NEAR(wgs84::semi_minor_axis_m, 6356752.3142, 5e-5);
  EXPECT_NEAR(wgs84::eccentricity_squared, 6.69437999014e-3, 5e-15);
  EXPECT_NEAR(meridian_radius(90 * arc_degree), 6399593.6258, 5e-5);  // polar radius of curvature
}

TEST(Earth, RadiiAtEquatorAndPoleHaveTheirClosedForms) {
  constexpr double a = wgs84::semi_major_axis_m, b = wgs84::semi_minor_axis_m;
  EXPECT_NEAR(meridian_radius(0), b * b / a, 1e-6);
  EXPECT_NEAR(transverse_radius(0), a, 1e-6);
  EXPECT_NEAR(transverse_radius(90 * arc_degree), a * a / b, 1e-6);
}

TEST(Earth, RadiiSayHowFarADegreeOfLatitudeAndOfLongitudeReaches) {
  const double h = 1e-5, height = 200;
  for (double latitude = -80 * arc_degree; latitude < 85 * arc_degree;
       latitude += 20 * arc_degree) {
    const Vector3d north = ecef({latitude + h, 0.3, height}) - ecef({latitude - h, 0.3, height});
    const Vector3d east = ecef({latitude, 0.3 + h, height}) - ecef({latitude, 0.3 - h, height});
    EXPECT_NEAR(north.norm() / (2 * h), meridian_radius(latitude) + height, 2e-3);
    EXPECT_NEAR(east.norm() / (2 * h), (transverse_radius(latitude) + height) * std::cos(latitude),
                2e-3);
  }
}

TEST(Earth, EarthRatePointsToThePole) {
  const double latitude = 36 * arc_degree;
  const Vector3d in_ecef =
      ecef_to_ned(latitude, 129 * arc_degree).transpose() * earth_rate_ned(latitude);
  EXPECT_LT((in_ecef - Vector3d{0, 0, 7.292115e-5}).norm(), 1e-19);
}

TEST(Earth, TransportRateIsHowTheNedAxesTurnAlongTheWay) {
  const double latitude = 50 * arc_degree, longitude = 0.2, height = -300, dt = 1;
  const Vector3d velocity{7, -12, 3};
  const double dlat = velocity.x() / (meridian_radius(latitude) + height);
  const double dlon = velocity.y() / (transverse_radius(latitude) + height) / std::cos(latitude);
  // C' = -[w]x C, by a central difference
  const Matrix3d ahead = ecef_to_ned(latitude + dlat * dt, longitude + dlon * dt);
  const Matrix3d behind = ecef_to_ned(latitude - dlat * dt, longitude - dlon * dt);
  const Matrix3d turn = -(ahead - behind) / (2 * dt) * ecef_to_ned(latitude, longitude).transpose();
  const Vector3d numeric{turn(2, 1), turn(0, 2), turn(1, 0)};
  EXPECT_LT((transport_rate_ned(latitude, height, velocity) - numeric).norm(), 1e-15);
}

TEST(Earth, GravityHasThePublishedValuesOnTheEllipsoid) {
  EXPECT_NEAR(gravity(0), 9.7803253359, 1e-12);
  EXPECT_NEAR(gravity(90 * arc_degree), 9.8321849378, 1e-12);
  EXPECT_NEAR(gravity(-90 * arc_degree), 9.8321849378, 1e-12);
  // Somigliana's original form with the two axes
  constexpr double a = 6378137.0, b = 6356752.3142, equator = 9.7803253359, pole = 9.8321849378;
  EXPECT_NEAR(gravity(45 * arc_degree), (a * equator + b * pole) / std::sqrt(2 * (a * a + b * b)),
              1e-10);
}

TEST(Earth, MeanGravityOverTheEllipsoidIsThatOfTr8350_2) {
  double weighted = 0, area = 0;
  const double step = 1e-4;
  for (double latitude = step / 2; latitude < std::numbers::pi / 2; latitude += step) {
    const double da = meridian_radius(latitude) * transverse_radius(latitude) * std::cos(latitude);
    weighted += gravity(latitude) * da;
    area += da;
  }
  EXPECT_NEAR(weighted / area, 9.7976432222, 1e-9);
}

TEST(Earth, GravityAloftIsThatOfAnotherProgram) {
  // Aerospace Toolbox, documentation of gravitywgs84(5000, 55, 'TaylorSeries')
  EXPECT_NEAR(gravity(55 * arc_degree, 5000), 9.7997, 5e-5);
}

TEST(Earth, FreeAirGradientIs0_3086MilligalPerMetre) {
  EXPECT_NEAR((gravity(45 * arc_degree, 100) - gravity(45 * arc_degree, -100)) / 200, -0.3086e-5,
              5e-10);
}

}  // namespace
}  // namespace drydock::frame
