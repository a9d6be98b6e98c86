#pragma once

#include <Eigen/Core>

#include "estimators/leveling/leveling_options.hpp"

/// Pure functions that both leveling filters use: eq. (5)-(28) of docs/estimators/leveling.md.
namespace drydock::leveling {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Eq. (5): the third column of C_n^b.
Eigen::Vector3d alpha_of(double roll_rad, double pitch_rad);

double roll_of(const Eigen::Vector3d& alpha);   ///< eq. (28), (-pi, pi]
double pitch_of(const Eigen::Vector3d& alpha);  ///< eq. (28) of alpha / |alpha|, [-pi/2, pi/2]

/// Covariance of [roll pitch], rad2, from that of alpha, with the Jacobian of eq. (28).
Eigen::Matrix2d roll_pitch_covariance(const Eigen::Vector3d& alpha,
                                      const Eigen::Matrix3d& covariance);

/// The first alpha and its standard deviation per component. The accelerometers give it, eq. (A6),
/// with the standard deviation `sigma`, or the options give it. In free fall the specific force has
/// no direction, so then the options give it too.
struct FirstAlpha {
  Eigen::Vector3d alpha;
  double sigma;
};
FirstAlpha first_alpha(const LevelingOptions& options, const Eigen::Vector3d& specific_force,
                       const Eigen::Vector3d& angular_rate, double speed_mps, double gravity_mps2,
                       double sigma);

/// F of eq. (26). `rate_nb`: [p q r], eq. (17); `rate_coriolis`: [p* q* r*], eq. (15).
Matrix6 system_matrix(const Eigen::Vector3d& rate_nb, const Eigen::Vector3d& rate_coriolis,
                      double gravity_mps2);

/// The transition over dt with a constant F, to the third order in A = F dt:
/// x <- step x + dt mean b, with step = e^A and mean = I + A/2 + A^2/6.
struct Transition {
  Transition(const Matrix6& f, double dt);
  Matrix6 mean, step;
};

/// The heading after dt, (-pi, pi]: third row of eq. (3). At pitch +-90 degrees it does not change.
double carried_heading(double heading_rad, const Eigen::Vector3d& alpha,
                       const Eigen::Vector3d& rate_nb, double dt);

/// Q of alpha, 1/s, by the scale factors and misalignments of gyros that turn at this rate: (A12).
double turn_noise(const LevelingOptions& options, const Eigen::Vector3d& rate);

/// Variances of the measurements V_y = 0 and V_z = 0 over dt at this rate of turn, eq. (A5). An
/// empty variance means that the constraint is not used.
struct Nonholonomic {
  Nonholonomic(const LevelingOptions& options, double turn_radps, double dt);
  std::optional<double> transverse, vertical;
};

}  // namespace drydock::leveling
