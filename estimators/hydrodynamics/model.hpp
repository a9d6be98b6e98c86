#pragma once

#include "estimators/hydrodynamics/vehicle.hpp"

/// Motion of an underwater vehicle in six degrees of freedom by the standard submarine equations
/// (Gertler and Hagen, NSRDC Report 2510, 1967), in the form of Lee, Ra, Kim, Ahn and Lee,
/// "Gertler-Hagen Hydrodynamic Model Based Velocity Estimation Filter for Long-term Underwater
/// Navigation Without External Position Fix" (2016). Equation numbers are those of
/// docs/estimators/hydrodynamics.md, which lists the corrections.
namespace drydock::hydrodynamics {

/// u v w p q r (body: m/s through the water, rad/s), x y z (NED: m over ground, z is the depth),
/// phi theta psi (rad).
using State = Eigen::Matrix<double, 12, 1>;

/// The surroundings of the vehicle, in NED.
struct Surroundings {
  Eigen::Vector3d current = Eigen::Vector3d::Zero();     ///< steady, water over ground, m/s
  Eigen::Vector3d earth_rate = Eigen::Vector3d::Zero();  ///< rad/s; 0: no rotation
};

/// Derivatives of the accelerations of eq. (4).
struct Partials {
  Matrix6 by_velocity;  ///< A of eq. (7) without its first row and column, u v w p q r
  /// The derivative by a small rotation sigma of the body about its own axes, in rad:
  /// C_n^b <- (I - sigma x) C_n^b.
  Eigen::Matrix<double, 6, 3> by_attitude;
};

/// [M - M_A, E - E_A; D - D_A, J - J_A]: the factor of the accelerations in eq. (2) and (3).
template <class Real>
BasicMatrix6<Real> mass_matrix(const BasicVehicle<Real>& vehicle);

/// True if the symmetric part is positive definite: then no motion has negative kinetic energy.
bool is_mass(const Matrix6& mass_matrix);

/// The equations of one vehicle. Allocates no memory after construction.
template <class Real>
class BasicModel {
 public:
  using Vector3 = Eigen::Vector3<Real>;
  using Matrix3 = Eigen::Matrix3<Real>;

  /// Throws std::invalid_argument (one line) if is_mass() refuses the mass matrix.
  explicit BasicModel(const BasicVehicle<Real>& vehicle);

  /// Of a mass matrix that was inverted before.
  BasicModel(const BasicVehicle<Real>& vehicle, const BasicMatrix6<Real>& inverse_mass)
      : vehicle_(vehicle), inverse_mass_(inverse_mass) {}

  /// Eq. (4): d/dt of u v w p q r. `ned_to_body`: C_n^b.
  BasicVelocity<Real> acceleration(const BasicVelocity<Real>& velocity, const Matrix3& ned_to_body,
                                   const Control& control,
                                   const Vector3& earth_rate_ned = Vector3::Zero()) const;

  /// Eq. (7) at the same arguments.
  Partials partials(const BasicVelocity<Real>& velocity, const Matrix3& ned_to_body,
                    const Control& control, const Vector3& earth_rate_ned = Vector3::Zero()) const;

  /// Only the derivative by u v w p q r.
  BasicMatrix6<Real> velocity_partials(const BasicVelocity<Real>& velocity,
                                       const Matrix3& ned_to_body, const Control& control,
                                       const Vector3& earth_rate_ned = Vector3::Zero()) const;

  /// Eq. (4) with the kinematics (1), (1a), (1b). Not defined at pitch +-pi/2.
  State derivative(const State& state, const Control& control,
                   const Surroundings& surroundings = {}) const;

  /// The state `dt` seconds later, by the classical Runge-Kutta method with constant control.
  State step(const State& state, const Control& control, double dt,
             const Surroundings& surroundings = {}) const;

  const BasicVehicle<Real>& vehicle() const { return vehicle_; }
  const BasicMatrix6<Real>& inverse_mass() const { return inverse_mass_; }

 private:
  /// The inverse mass matrix times these columns. Surge, heave and pitch do not couple with sway,
  /// roll and yaw in it, so each row has three factors that are not zero.
  template <int Columns>
  Eigen::Matrix<Real, 6, Columns> accelerations(
      const Eigen::Matrix<Real, 6, Columns>& wrenches) const;

  BasicVehicle<Real> vehicle_;
  BasicMatrix6<Real> inverse_mass_;
};
using Model = BasicModel<double>;

}  // namespace drydock::hydrodynamics
