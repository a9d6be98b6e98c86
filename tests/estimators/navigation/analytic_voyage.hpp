#pragma once

#include <array>

#include "estimators/navigation/sdins.hpp"

/// A motion over the Earth in closed form, and what inertial sensors sum up on it: the witness of
/// the mechanization. Its only common ground with it is the Earth of estimators/frame.
namespace drydock::navigation::test {

/// Climbs, dives, turns and rolls without pause, in sines of one to forty minutes.
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
  /// Integrals over [t, t + dt] by Gauss and Legendre's two points.
  Sample sample(double t, double dt) const;
};

/// Horizontal distance between two places, m.
double horizontal_distance(const frame::Position& a, const frame::Position& b);

}  // namespace drydock::navigation::test
