#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "drivers/measurement/units.hpp"
#include "estimators/navigation/innovation.hpp"

namespace drydock::leveling {

/// The kinds of filter; docs/estimators/leveling.md compares them.
enum class FilterKind : std::uint8_t {
  paper,     ///< as printed, errors corrected: starts from a given attitude, may stay upside down
  robust,    ///< the same six states, never upside down
  augmented  ///< thirteen states: the biases of accelerometers, gyros and log as well
};

/// All sigmas are one standard deviation. "Paper": the paper states it; "chosen": the docs page
/// says why. The defaults are those of FilterKind::robust.
struct LevelingOptions {
  double latitude_rad = 0;  ///< for Earth rate and gravity, eq. (16); within about a degree
  double height_m = 0;      ///< for gravity
  double heading_rad = 0;   ///< at the start, for eq. (16); later the gyro updates it

  /// True: the first specific force gives the first attitude. False: initial_roll and
  /// initial_pitch.
  bool accelerometer_start = true;
  double initial_roll_rad = 0, initial_pitch_rad = 0;

  double initial_velocity_sigma_mps = 1;         ///< P0 of V; chosen
  double initial_alpha_sigma = 1;                ///< P0 of alpha without attitude knowledge; paper
  double accelerometer_start_alpha_sigma = 0.1;  ///< P0 of alpha with accelerometer start; chosen

  /// For a restart after the IMU was silent: P0 of alpha, an acceleration of .3 m/s2 divided by
  /// gravity; and the assumed rate of turn in the silence, that of the paper's S path. Chosen.
  double restart_alpha_sigma = 0.03;
  double unseen_turn_radps = 0.12;

  double velocity_noise = 3e-3;  ///< Q of V, m/s per sqrt(s); chosen
  double alpha_noise = 1e-5;     ///< Q of alpha, 1 per sqrt(s); chosen

  double speed_sigma_mps = 0.1;        ///< R of V_x moving; paper, Table 1
  double stationary_sigma_mps = 0.01;  ///< R of V stationary; chosen
  double norm_sigma = 0.1;             ///< R of |alpha|^2 = 1; chosen
  /// With an accelerometer start, a speed with an innovation above this many sigmas is not used.
  /// The paper has no gate: infinite.
  double speed_gate = 6;

  /// Nonholonomic constraints, eq. (A5): standard deviation of V_z = 0 and V_y = 0, m/s sqrt(s);
  /// empty: not used. V_z = 0 decides the sign of alpha_3. V_y = 0 holds roll on a straight course.
  /// The paper's measurements observe neither while p = q = 0. A vehicle slips sideways in a turn:
  /// the variance of V_y = 0 grows by the square of `slip_density`, m sqrt(s), times the rate of
  /// turn.
  std::optional<double> vertical_speed_density = 0.3;
  std::optional<double> transverse_speed_density = 0.2;
  double slip_density = 8;

  /// P0 of the biases, per axis, for FilterKind::augmented only. Paper, Table 1.
  double accelerometer_bias_sigma_mps2 = units::milli_g;  ///< 1 mg
  double gyro_bias_sigma_radps = units::degree_per_hour;  ///< 1 deg/h
  double speed_bias_sigma_mps = 0.1;
  /// Random walks of the biases, per sqrt(s), for FilterKind::augmented only.
  double gyro_bias_walk_radps = 0, accelerometer_bias_walk_mps2 = 0;
  double rate_share = 0;  ///< error of a rate by scale factor and misalignment, as its share
};

/// The options of this kind of filter. The caller sets latitude, heading and attitude.
LevelingOptions options_for(FilterKind kind);

/// The innovation of the last update: z - h(x), its normalised square (NIS), degrees of freedom.
struct Innovation {
  Eigen::Vector4d residual = Eigen::Vector4d::Zero();  ///< first `size` entries
  int size = 0;
  double normalised_square = 0;
  std::optional<navigation::Innovation> log;  ///< of the speed log alone, used or not, m/s
};

/// The innovations of V_y = 0 and V_z = 0 at the last step, each over its standard deviation; 0:
/// not used.
struct ConstraintInnovations {
  double transverse = 0, vertical = 0;
};

}  // namespace drydock::leveling
