#include "hil/summary/error_statistics.hpp"

#include <Eigen/LU>
#include <numbers>

#include "drivers/measurement/units.hpp"

namespace drydock::summary {
namespace {

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace

void ErrorStatistics::add(const bus::Attitude& estimate, const motion::Truth& truth, double t_s) {
  const Eigen::Vector2d error{wrapped(estimate.roll_rad - truth.roll_rad),
                              wrapped(estimate.pitch_rad - truth.pitch_rad)};
  if (!error.allFinite()) return;
  roll_.add(error.x());
  pitch_.add(error.y());
  const double normalised = error.dot(estimate.covariance.inverse() * error) / 2;
  nees_.add_square(normalised, normalised);
  settled_ = error.lpNorm<Eigen::Infinity>() <= settled_deg * units::degree;
  if (!settled_) wide_s_ = t_s;
}

AttitudeError ErrorStatistics::result() const {
  return {.roll_rms_deg = roll_.rms() * units::degrees_per_radian,
          .pitch_rms_deg = pitch_.rms() * units::degrees_per_radian,
          .roll_max_deg = roll_.largest() * units::degrees_per_radian,
          .pitch_max_deg = pitch_.largest() * units::degrees_per_radian,
          .nees_mean = nees_.mean(),
          .settling_s = settled_ ? wide_s_ : std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace drydock::summary
