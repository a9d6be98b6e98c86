#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "estimators/mixing/maneuver_level.hpp"
#include "estimators/mixing/stepped_angle.hpp"

/// Roll and pitch from gyroscopes, corrected by accelerometers and a speed log: the mixing loop of
/// Kim, Lee and Han, "Mixing Algorithm for Attitude Computation of Underwater Vehicle Using Fuzzy
/// Theory" (1996). Equation numbers are those of docs/estimators/mixing.md.
namespace drydock::mixing {

/// The types of Table 4 of the paper, and one type of this project.
enum class MixingType : std::uint8_t {
  fixed_gain,       ///< type 1: the older loop with constant gains
  fuzzy_inference,  ///< type 2: gains by fuzzy inference
  gain_schedule,    ///< type 3: gains by Table 3
  compensated       ///< type 2 with compensation of acceleration and side slip
};

/// The text of the paper allows both readings.
enum class IntegralGain : std::uint8_t { k1_k2, k2_alone };

/// "Paper": the paper states it; "chosen": the docs page says why.
struct MixingOptions {
  MixingType type = MixingType::compensated;
  IntegralGain integral_gain = IntegralGain::k1_k2;  ///< chosen
  Gains fixed{0.008, 0.00125};                       ///< type 1; paper, Table 4
  FuzzySets sets;                                    ///< chosen, within Table 3

  double latitude_rad = 0;  ///< for Earth rate and gravity; within about a degree
  double heading_rad = 0;   ///< at the start; later the gyro updates it

  /// True: the first specific force gives the first attitude. False: initial_roll and
  /// initial_pitch.
  bool accelerometer_start = true;
  double initial_roll_rad = 0, initial_pitch_rad = 0;
  /// After an accelerometer start the gains are those of level 1 for this time. Without it a wrong
  /// first attitude looks like a manoeuvre and stays. Chosen.
  double settling_s = 60;

  double low_pass_s = 0.5;      ///< time constant for (6) and (7); 0: no low-pass; chosen
  double velocity_leak_s = 20;  ///< decay time of v and w, eq. (8); chosen

  double pivot_m = 0;           ///< compensated: v = -pivot r, w = pivot q; 0: not known
  double integral_leak_s = 50;  ///< compensated: decay time of the integral; chosen
};

/// Allocates nothing, throws nothing; inputs must be finite (the pipeline checks them).
class MixingFilter {
 public:
  explicit MixingFilter(const MixingOptions& options);

  /// Starts with the attitude that the options say. The heading is kept.
  void start(const Eigen::Vector3d& specific_force, const Eigen::Vector3d& angular_rate,
             double speed_mps);
  /// Starts with the attitude of the first specific force, whatever the options say.
  void start_by_accelerometers(const Eigen::Vector3d& specific_force,
                               const Eigen::Vector3d& angular_rate, double speed_mps);

  /// One step of `dt` seconds with constant inputs (m/s2 and rad/s, body; m/s ahead).
  void step(const Eigen::Vector3d& specific_force, const Eigen::Vector3d& angular_rate,
            double speed_mps, double dt);

  double roll() const { return roll_.angle(); }    ///< [-pi, pi]; not valid beyond +-pi/2
  double pitch() const { return pitch_.angle(); }  ///< [-pi/2, pi/2]
  /// "Down" in body axes, C_n^b [0 0 1].
  Eigen::Vector3d down() const {
    return {-pitch_.sine(), roll_.sine() * pitch_.cosine(), roll_.cosine() * pitch_.cosine()};
  }
  double gravity_mps2() const { return gravity_; }
  double heading() const { return heading_.angle(); }  ///< the given heading plus the gyro's turn
  int level() const { return level_; }    ///< manoeuvre level, 1 to 12; always 1 for type 1
  Gains gains() const { return gains_; }  ///< of the last step
  double integral_gain() const;           ///< 1/s2, see IntegralGain
  double integral_leak() const;           ///< 1/s
  const MixingOptions& options() const { return options_; }

 private:
  struct Motion;

  void forget(const Eigen::Vector3d& angular_rate, double speed_mps);
  void discretise(double dt);
  // Only step() calls what is inline here, so they stand in its file.
  inline Motion observe(const Eigen::Vector3d& specific_force, const Eigen::Vector3d& angular_rate,
                        double speed_mps, double dt) const;
  inline Eigen::Vector2d accelerometer_error(const Motion& motion) const;
  Eigen::Vector2d compensated_error(const Motion& motion);
  inline void choose_gains(const Motion& motion);

  MixingOptions options_;
  double gravity_, per_gravity_;
  Eigen::Vector3d earth_rate_ned_;

  SteppedAngle roll_{0}, pitch_{0}, heading_;
  Eigen::Vector2d integral_ = Eigen::Vector2d::Zero();
  int level_ = 1;
  Gains gains_;
  double settling_left_s_ = 0;

  // State of the two inputs of the manoeuvre level, eq. (6) and (7).
  Eigen::Vector2d slow_rate_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d slow_force_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d drift_ = Eigen::Vector2d::Zero();  ///< v and w integrated from (8)

  // State of the compensation.
  Eigen::Vector2d slow_turn_ = Eigen::Vector2d::Zero();  ///< q and r
  double slow_residual_ = 0, slow_speed_ = 0, unexplained_x_ = 0;

  double dt_ = 0;        ///< the next three values belong to this step length
  double low_pass_ = 1;  ///< weight of a new input
  double drift_kept_ = 1, integral_kept_ = 1;
};

}  // namespace drydock::mixing
