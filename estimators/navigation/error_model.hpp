#pragma once

#include <Eigen/Core>
#include <array>
#include <type_traits>

#include "estimators/frame/local_earth.hpp"
#include "estimators/navigation/sdins.hpp"

/// Eq. (14): the dynamics of the errors of an SDINS. The states are IN minus truth: latitude,
/// longitude (rad) and height (m); V^N (m/s); phi (rad), C_IN = (I - phi x) C; biases of gyros
/// (rad/s) and accelerometers (m/s2) in body axes. A bias adds to the measured value.
namespace drydock::navigation {

/// First index of each of the five blocks of three.
enum ErrorBlock { position_error = 0, velocity_error = 3, phi = 6, gyro_bias = 9, accel_bias = 12 };

/// The nonzero rows of F: d/dt of position, velocity and attitude by all 15 states.
template <class Real>
using BasicErrorDynamics = Eigen::Matrix<Real, 9, 15>;
using ErrorDynamics = BasicErrorDynamics<double>;

/// F at a state with the specific force `force_ned` (m/s2) and the gains of the height loop.
template <class Real>
BasicErrorDynamics<Real> error_dynamics(const BasicNavigationState<Real>& state,
                                        const std::type_identity_t<Eigen::Vector3<Real>>& force_ned,
                                        const HeightLoop& loop = {});

/// The same where the Earth at the state's position is known already.
template <class Real>
BasicErrorDynamics<Real> error_dynamics(const BasicNavigationState<Real>& state,
                                        const frame::BasicLocalEarth<Real>& earth,
                                        const Eigen::Vector3<Real>& force_ned,
                                        const HeightLoop& loop);

/// The columns of each row of F that may differ from zero. Code that uses F skips the others.
struct ErrorDynamicsRow {
  int entries;
  std::array<int, 10> columns;
};
inline constexpr std::array<ErrorDynamicsRow, 9> error_dynamics_pattern{{
    {3, {0, 2, 3}},                           // latitude
    {3, {0, 2, 4}},                           // longitude
    {2, {2, 5}},                              // height
    {10, {0, 2, 3, 4, 5, 7, 8, 12, 13, 14}},  // V^N
    {10, {0, 2, 3, 4, 5, 6, 8, 12, 13, 14}},  // V^E
    {9, {0, 2, 3, 4, 6, 7, 12, 13, 14}},      // V^D
    {8, {0, 2, 4, 7, 8, 9, 10, 11}},          // phi
    {8, {0, 2, 3, 6, 8, 9, 10, 11}},
    {8, {0, 2, 4, 6, 7, 9, 10, 11}},
}};

}  // namespace drydock::navigation
