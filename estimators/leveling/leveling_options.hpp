#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <numbers>
#include <optional>

#include "estimators/navigation/innovation.hpp"

namespace drydock::leveling {

/// Which of the filters; docs/estimators/leveling.md compares them.
enum class FilterKind : std::uint8_t {
  paper,     ///< as printed, errata corrected: starts from a given attitude, may stay upside down
  robust,    ///< the same six states, never upside down
  augmented  ///< thirteen states: the biases of accelerometers, gyros and log as well
};

/// One standard deviation everywhere. "Paper": stated there; "chosen": see the docs page for why.
/// The defaults are those of FilterKind::robust.
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

  /// After an IMU's silence: P0 of alpha, an acceleration of .3 m/s2 over gravity; and the rate of
  /// turn of a vehicle that nobody sees, that of the paper's S path. Chosen.
  double restart_alpha_sigma = 0.03;
  double unseen_turn_radps = 0.12;

  double velocity_noise = 3e-3;  ///< Q of V, m/s per sqrt(s); chosen
  double alpha_noise = 1e-5;     ///< Q of alpha, 1 per sqrt(s); chosen

  double speed_sigma_mps = 0.1;        ///< R of V_x moving; paper, Table 1
  double stationary_sigma_mps = 0.01;  ///< R of V stationary; chosen
  double norm_sigma = 0.1;             ///< R of |alpha|^2 = 1; chosen
  /// With an accelerometer start: a speed further off, in its sigmas, is not used; paper: infinite.
  double speed_gate = 6;

  /// Nonholonomic constraints, eq. (A5): V_z and V_y are zero to this much, m/s sqrt(s); empty: not
  /// used. The first decides the sign of alpha_3, the second holds roll on a straight course: the
  /// paper's measurements leave both open while p = q = 0. A vehicle slips sideways as it turns:
  /// `slip_density`, m sqrt(s), times the rate of turn is added to the second, squared.
  std::optional<double> vertical_speed_density = 0.3;
  std::optional<double> transverse_speed_density = 0.2;
  double slip_density = 8;

  /// P0 of the biases, per axis; FilterKind::augmented alone. Paper, Table 1.
  double accelerometer_bias_sigma_mps2 = 9.80665e-3;        ///< 1 mg
  double gyro_bias_sigma_radps = std::numbers::pi / 648e3;  ///< 1 deg/h
  double speed_bias_sigma_mps = 0.1;
};

/// What each filter differs in from the others; latitude, heading and attitude are for the caller.
LevelingOptions options_for(FilterKind kind);

/// What the last update saw: z - h(x), its normalised square (NIS) and the degrees of freedom.
struct Innovation {
  Eigen::Vector4d residual = Eigen::Vector4d::Zero();  ///< first `size` entries
  int size = 0;
  double normalised_square = 0;
  std::optional<navigation::Innovation> log;  ///< that of the speed log alone, used or not, m/s
};

}  // namespace drydock::leveling
