#pragma once

#include <Eigen/Core>

#include "estimators/leveling/leveling_options.hpp"

/// What the leveling filters have in common: eq. (5)-(28) of docs/estimators/leveling.md, pure.
namespace drydock::leveling {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Eq. (5): the third column of C_n^b.
Eigen::Vector3d alpha_of(double roll_rad, double pitch_rad);

double roll_of(const Eigen::Vector3d& alpha);   ///< eq. (28), (-pi, pi]
double pitch_of(const Eigen::Vector3d& alpha);  ///< eq. (28) of alpha / |alpha|, [-pi/2, pi/2]

/// Covariance of [roll pitch], rad2, from that of alpha: through the Jacobian of eq. (28).
Eigen::Matrix2d roll_pitch_covariance(const Eigen::Vector3d& alpha,
                                      const Eigen::Matrix3d& covariance);

/// alpha to begin with, and its uncertainty per component: by the accelerometers, eq. (A6), which
/// are good to `sigma`, or as the options give it; so also in free fall, where a specific force
/// tells no direction.
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

/// F constant over dt, to the third order in A = F dt: x <- step x + dt mean b, with
/// step = e^A and mean = I + A/2 + A^2/6.
struct Transition {
  Transition(const Matrix6& f, double dt);
  Matrix6 mean, step;
};

/// The heading after dt, (-pi, pi]: third row of eq. (3). At pitch +-90 degrees it stands still.
double carried_heading(double heading_rad, const Eigen::Vector3d& alpha,
                       const Eigen::Vector3d& rate_nb, double dt);

/// Variances of V_y = 0 and V_z = 0 over dt at this rate of turn, eq. (A5); empty: not used.
struct Nonholonomic {
  Nonholonomic(const LevelingOptions& options, double turn_radps, double dt);
  std::optional<double> transverse, vertical;
};

}  // namespace drydock::leveling
