#pragma once

#include <optional>

#include "estimators/smoothing/level_state.hpp"
#include "estimators/smoothing/sensor_model.hpp"

namespace drydock::smoothing {

/// One standard deviation of each error at the start.
struct LevelSigmas {
  double position_m = 100, depth_m = 5, velocity_mps = 3;
  double heading_rad = 0.2, turn_radps = 0.1;
  double heading_bias_rad = 0.02;
  double current_mps = 0.5;
  /// Constant over a dive, and the same for all bottom tracks or logs.
  double bottom_scale = 0, log_scale = 0;
};

struct LevelOptions {
  LevelState start;
  LevelSigmas sigmas;
  LevelMotion motion;
  SensorModels sensors;      ///< by device; a device beyond the end has the default model
  bool fix_heights = false;  ///< heights of fixes are measured too; else depths tell the height
  double gate_sigma = 5;     ///< axes with a larger normalised residual are refused; 0: no gate
};

/// The next heading from the begin of a step on. A heading that was lost is found again there.
struct HeadingAhead {
  const Reading* reading = nullptr;  ///< null: none comes
  double in_s = 0;
  double speed_mps = 0;  ///< of the vehicle there
};

/// Extended Kalman filter of a LevelState. Allocates nothing, throws nothing; values are finite or
/// NaN for an axis that was not measured.
class LevelFilter {
 public:
  explicit LevelFilter(const LevelOptions& options);

  /// Returns the transition of the errors over `dt`.
  LevelMatrix propagate(double dt, const HeadingAhead& ahead);

  /// Compares a reading with the state at its time, and corrects the state with the axes inside
  /// the gate. Residuals are relative to the state before the whole reading, in its units; those
  /// of a fix are m north, east, down.
  std::array<Residual, 3> update(const Reading& reading, const Tilt& tilt);

  const LevelState& state() const { return state_; }
  const LevelMatrix& covariance() const { return p_; }
  /// The sum of the corrections since propagate().
  const LevelVector& correction() const { return correction_; }

 private:
  /// An axis of a measurement: what the state lets expect, and the derivative by the errors.
  struct Row {
    double expected = 0;
    LevelVector slope = LevelVector::Zero();
  };
  using Rows = std::array<Row, 3>;

  LevelMatrix step(double dt, const LevelMotion& motion, const Eigen::Matrix3d& axes);
  /// True if after `dt` the heading may be any, or is another than the filter can explain.
  bool loses_heading(double dt, const HeadingAhead& ahead) const;
  /// Makes one of the errors independent, with this sigma. Returns the transition of that.
  LevelMatrix forget(int part, double sigma);
  /// After a run of refused headings the state is wrong rather than they.
  LevelMatrix forget_refused_heading();
  /// Forgets heading and turn, eq. (S14): their linear errors would turn into any way.
  LevelMatrix cross_gap(double dt, const HeadingAhead& ahead);
  Rows rows_of(const Reading& reading, const Tilt& tilt) const;
  Rows velocity_rows(const SensorModel& sensor, const Tilt& tilt, bool of_water) const;
  Rows fix_rows(const Reading& reading, const SensorModel& sensor, const Tilt& tilt) const;
  Row heading_row(const SensorModel& sensor) const;
  /// Without `tells_scale` the scales are uncertain but not corrected. A speed and a scale
  /// multiply, so a linear filter would learn from each new estimate of the speed what nothing told
  /// it.
  Residual take(const Row& row, double residual, double variance, bool tells_scale,
                LevelVector& errors);
  const SensorModel& sensor(std::uint16_t device) const;

  const LevelOptions& options_;
  LevelState state_;
  LevelMatrix p_ = LevelMatrix::Zero();
  LevelVector correction_ = LevelVector::Zero();
  int refused_headings_ = 0;  ///< one after the other
  double unseen_s_ = 0;       ///< since a heading was used
  double usual_s_ = 0;        ///< between the two used before
};

}  // namespace drydock::smoothing
