#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>

#include "estimators/navigation/sdins.hpp"

/// Eq. (14): how the errors of an SDINS grow. State, IN minus truth: latitude, longitude (rad) and
/// height (m); V^N (m/s); phi (rad), C_IN = (I - phi x) C; biases of gyros (rad/s) and
/// accelerometers (m/s2) in body axes, which add to what the sensors measure.
namespace drydock::navigation {

/// First entries of the five blocks of three.
enum ErrorBlock { position_error = 0, velocity_error = 3, phi = 6, gyro_bias = 9, accel_bias = 12 };

/// The rows of F that are not zero: d/dt of position, velocity and attitude by all 15.
using ErrorDynamics = Eigen::Matrix<double, 9, 15>;

/// F at a state that feels `force_ned` (m/s2), with the gains of its height loop.
ErrorDynamics error_dynamics(const NavigationState& state, const Eigen::Vector3d& force_ned,
                             const HeightLoop& loop = {});

/// Where F may differ from zero: row, column. What is built on F does no work elsewhere.
inline constexpr auto error_dynamics_pattern = std::to_array<std::pair<int, int>>({
    {0, 0}, {0, 2}, {0, 3},  // latitude
    {1, 0}, {1, 2}, {1, 4},  // longitude
    {2, 2}, {2, 5},          // height
    {3, 0}, {3, 2}, {3, 3}, {3, 4}, {3, 5},  {3, 7},  {3, 8},  {3, 12}, {3, 13}, {3, 14},  // V^N
    {4, 0}, {4, 2}, {4, 3}, {4, 4}, {4, 5},  {4, 6},  {4, 8},  {4, 12}, {4, 13}, {4, 14},  // V^E
    {5, 0}, {5, 2}, {5, 3}, {5, 4}, {5, 6},  {5, 7},  {5, 12}, {5, 13}, {5, 14},           // V^D
    {6, 0}, {6, 2}, {6, 4}, {6, 7}, {6, 8},  {6, 9},  {6, 10}, {6, 11},                    // phi
    {7, 0}, {7, 2}, {7, 3}, {7, 6}, {7, 8},  {7, 9},  {7, 10}, {7, 11}, {8, 0},  {8, 2},
    {8, 4}, {8, 6}, {8, 7}, {8, 9}, {8, 10}, {8, 11},
});

}  // namespace drydock::navigation
