#pragma once

#include <Eigen/Core>
#include <optional>

/// Roll and pitch from an inertial measurement unit and a speed log, without knowing either to
/// begin with: the extended Kalman filter of Hong, Park, Han and Lee, "A Leveling Algorithm for
/// Strapdown INS Using EKF" (2000). Equation numbers are those of docs/estimators/leveling.md.
namespace drydock::leveling {

/// One standard deviation everywhere. "Paper": stated there; "chosen": see the docs page for why.
struct LevelingOptions {
  double latitude_rad = 0;  ///< earth rate and gravity, eq. (16); needed to about a degree
  double height_m = 0;      ///< gravity
  double heading_rad = 0;   ///< at the start; eq. (16) needs it, the gyro carries it on

  /// First attitude from the first specific force; false: from initial_roll and initial_pitch.
  bool accelerometer_start = true;
  double initial_roll_rad = 0, initial_pitch_rad = 0;

  double initial_velocity_sigma_mps = 1;         ///< P0 of V; chosen
  double initial_alpha_sigma = 1;                ///< P0 of alpha without attitude knowledge; paper
  double accelerometer_start_alpha_sigma = 0.1;  ///< P0 of alpha with accelerometer start; chosen

  double velocity_noise = 3e-3;  ///< Q of V, m/s per sqrt(s); chosen
  double alpha_noise = 1e-5;     ///< Q of alpha, 1 per sqrt(s); chosen

  double speed_sigma_mps = 0.1;        ///< R of V_x moving; paper, Table 1
  double stationary_sigma_mps = 0.01;  ///< R of V stationary; chosen
  double norm_sigma = 0.1;             ///< R of |alpha|^2 = 1; chosen

  /// Nonholonomic constraints: V_z, V_y are zero to this much, m/s sqrt(s); empty: not used. The
  /// first decides the sign of alpha_3, the second holds roll on a straight course: the paper's
  /// measurements leave both open while p = q = 0.
  std::optional<double> vertical_speed_density = 0.3;
  std::optional<double> transverse_speed_density = 1.0;
};

/// What the last update saw: z - h(x), its normalised square (NIS) and the degrees of freedom.
struct Innovation {
  Eigen::Vector4d residual = Eigen::Vector4d::Zero();  ///< first `size` entries
  int size = 0;
  double normalised_square = 0;
};

/// State x = [V_x V_y V_z alpha_1 alpha_2 alpha_3]: velocity over the Earth in body axes, m/s, and
/// alpha = third column of C_n^b, "down" seen from the body. Allocates nothing, throws nothing;
/// inputs must be finite (the pipeline sees to that).
class LevelingFilter {
 public:
  using State = Eigen::Matrix<double, 6, 1>;
  using Covariance = Eigen::Matrix<double, 6, 6>;

  explicit LevelingFilter(const LevelingOptions& options);

  /// Begins, or begins again: attitude as the options say, V = [speed 0 0]. The heading is kept.
  void start(const Eigen::Vector3d& specific_force, const Eigen::Vector3d& angular_rate,
             double speed_mps);

  /// Eq. (21), (22) over dt seconds, in which the inputs (m/s2 and rad/s, body) are constant.
  void predict(const Eigen::Vector3d& specific_force, const Eigen::Vector3d& angular_rate,
               double dt);

  /// Eq. (29)-(31): speed along body x, and |alpha|^2 = 1.
  void update_moving(double speed_mps);

  /// Eq. (32)-(34): all three velocities are zero, and |alpha|^2 = 1.
  void update_stationary();

  /// The constraints that the options switch on, for `dt` seconds of motion; none: does nothing.
  void update_nonholonomic(double dt);

  double roll() const;                         ///< eq. (28), (-pi, pi]
  double pitch() const;                        ///< eq. (28), [-pi/2, pi/2]
  double heading() const { return heading_; }  ///< the given one carried on by the gyro, (-pi, pi]

  /// Covariance of [roll pitch], rad2: that of alpha through the Jacobian of eq. (28).
  Eigen::Matrix2d roll_pitch_covariance() const;

  const State& state() const { return x_; }
  const Covariance& covariance() const { return p_; }
  const Innovation& innovation() const { return innovation_; }
  const LevelingOptions& options() const { return options_; }
  double gravity_mps2() const { return gravity_; }

  /// F of eq. (26). `rate_nb`: [p q r], eq. (17); `rate_coriolis`: [p* q* r*], eq. (15).
  static Covariance system_matrix(const Eigen::Vector3d& rate_nb,
                                  const Eigen::Vector3d& rate_coriolis, double gravity_mps2);

 private:
  template <int Rows>
  void update(const Eigen::Matrix<double, Rows, 1>& residual,
              const Eigen::Matrix<double, Rows, 6>& h,
              const Eigen::Matrix<double, Rows, 1>& variance);

  Eigen::Vector3d earth_rate_body() const;
  void carry_heading(const Eigen::Vector3d& rate_nb, double dt);

  LevelingOptions options_;
  double gravity_;
  Eigen::Vector3d earth_rate_ned_;
  double heading_;
  State x_ = State::Zero();
  Covariance p_ = Covariance::Zero();
  Innovation innovation_;
};

}  // namespace drydock::leveling
