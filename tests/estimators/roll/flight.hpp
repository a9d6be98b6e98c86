#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "estimators/frame/attitude.hpp"
#include "estimators/roll/epoch.hpp"

namespace drydock::roll::test {

inline constexpr double degree = std::numbers::pi / 180;

/// Directions of satellites in all parts of the sky: elevation, azimuth in degrees.
inline constexpr std::array<std::array<double, 2>, 8> directions{
    {{70, 10}, {55, 130}, {45, 250}, {35, 330}, {30, 60}, {20, 180}, {15, 290}, {10, 110}}};

/// Eq. (23), corrected.
inline double pattern(double off_boresight_deg) {
  return std::exp(-std::pow(off_boresight_deg / 64.58, 2));
}

/// A steady roll at a constant pitch, with the antenna on body +z.
struct Flight {
  double rate_radps = 90 * degree, first_roll = 1.3, pitch = 20 * degree, azimuth = 70 * degree;
  double gain = 1, noise = 0;
  std::mt19937_64 random{1};
  std::array<Signal, directions.size()> signals;

  double roll(double t) const { return first_roll + rate_radps * t; }
  FlightPath path() const { return {azimuth, pitch}; }

  std::span<const Signal> at(double t) {
    std::normal_distribution<double> normal(0, 1);
    const Eigen::Matrix3d to_body = frame::ned_to_body({roll(t), pitch, azimuth});
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double el = directions[i][0] * degree, az = directions[i][1] * degree;
      const Eigen::Vector3d toward{std::cos(el) * std::cos(az), std::cos(el) * std::sin(az),
                                   -std::sin(el)};
      const double off = std::acos((to_body * toward).z()) / degree;
      signals[i] = {static_cast<std::uint16_t>(i), toward,
                    gain * pattern(off) + noise * normal(random)};
    }
    return signals;
  }
};

}  // namespace drydock::roll::test
