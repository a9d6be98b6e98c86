#include "tests/estimators/navigation/analytic_voyage.hpp"

#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "estimators/frame/local_earth.hpp"

namespace drydock::navigation::test {
namespace {

using Eigen::Vector3d;

/// offset + slope t + amplitude sin(w t + phase), and its derivatives.
struct Wave {
  double offset, slope, amplitude, w, phase;
  double value(double t) const { return offset + slope * t + amplitude * std::sin(w * t + phase); }
  double first(double t) const { return slope + amplitude * w * std::cos(w * t + phase); }
  double second(double t) const { return -amplitude * w * w * std::sin(w * t + phase); }
};

constexpr Wave latitude{0.63, 3e-7, 4e-5, 0.011, 0}, longitude{2.25, 2.5e-7, 5e-5, 0.009, 1};
constexpr Wave height{-120, 0, 90, 0.005, 2};
constexpr Wave roll{0, 0, 0.1, 0.1, 0}, pitch{0, 0, 0.3, 0.02, 1}, yaw{0.8, 0.004, 0.5, 0.03, 0};

frame::Euler attitude_at(double t) { return {roll.value(t), pitch.value(t), yaw.value(t)}; }

Vector3d velocity_at(double t, const frame::LocalEarth& earth) {
  return {(earth.meridian_radius_m + height.value(t)) * latitude.first(t),
          (earth.transverse_radius_m + height.value(t)) * earth.cos_latitude * longitude.first(t),
          -height.first(t)};
}

}  // namespace

NavigationState AnalyticVoyage::at(double t) const {
  const frame::Position position{latitude.value(t), frame::wrap_pi(longitude.value(t)),
                                 height.value(t)};
  return {position, velocity_at(t, frame::local_earth(position.latitude_rad, position.height_m)),
          frame::body_to_ned(attitude_at(t))};
}

AnalyticVoyage::Felt AnalyticVoyage::felt(double t) const {
  const double h = height.value(t), lat_rate = latitude.first(t), lon_rate = longitude.first(t);
  const frame::LocalEarth earth = frame::local_earth(latitude.value(t), h);
  const Vector3d v = velocity_at(t, earth);
  const double north_radius = earth.meridian_radius_m + h,
               east_radius = earth.transverse_radius_m + h;
  const double north_radius_rate = earth.meridian_slope_m * lat_rate + height.first(t);
  const double east_radius_rate = earth.transverse_slope_m * lat_rate + height.first(t);
  const Vector3d acceleration{
      north_radius_rate * lat_rate + north_radius * latitude.second(t),
      (east_radius_rate * earth.cos_latitude - east_radius * earth.sin_latitude * lat_rate) *
              lon_rate +
          east_radius * earth.cos_latitude * longitude.second(t),
      -height.second(t)};
  const Vector3d earth_rate{earth.rate_north, 0, earth.rate_down};
  const Vector3d transport_rate{lon_rate * earth.cos_latitude, -lat_rate,
                                -lon_rate * earth.sin_latitude};
  const frame::Euler attitude = attitude_at(t);
  const Eigen::Matrix3d to_body = frame::ned_to_body(attitude);
  return {frame::body_rate(attitude, {roll.first(t), pitch.first(t), yaw.first(t)}) +
              to_body * (earth_rate + transport_rate),
          to_body * (acceleration + (2 * earth_rate + transport_rate).cross(v) -
                     Vector3d{0, 0, earth.gravity_mps2})};
}

AnalyticVoyage::Sample AnalyticVoyage::sample(double t, double dt) const {
  const double off = dt / 2 / std::sqrt(3.0);
  const Felt a = felt(t + dt / 2 - off), b = felt(t + dt / 2 + off);
  return {dt / 2 * (a.rate + b.rate), dt / 2 * (a.force + b.force)};
}

double horizontal_distance(const frame::Position& a, const frame::Position& b) {
  return frame::ned_offset(a, b).head<2>().norm();
}

}  // namespace drydock::navigation::test
