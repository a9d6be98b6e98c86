#pragma once

#include <array>

#include "estimators/navigation/sdins.hpp"

/// A motion over the Earth in closed form with the integrals of its inertial sensors: an
/// independent check of the mechanization. Both share only the Earth of estimators/frame.
namespace drydock::navigation::test {

/// It climbs, dives, turns and rolls all the time, by sines with periods of one to forty minutes.
class AnalyticVoyage {
 public:
  NavigationState at(double t) const;

  struct Felt {
    Eigen::Vector3d rate, force;  ///< body against inertial, rad/s; specific force, m/s2; body
  };
  Felt felt(double t) const;

  struct Sample {
    Eigen::Vector3d angle, velocity;
  };
  /// Integrals over [t, t + dt] by Gauss-Legendre with two points.
  Sample sample(double t, double dt) const;
};

/// Horizontal distance between two places, m.
double horizontal_distance(const frame::Position& a, const frame::Position& b);

}  // namespace drydock::navigation::test
