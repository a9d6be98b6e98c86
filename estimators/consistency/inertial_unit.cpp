#include "estimators/consistency/inertial_unit.hpp"

#include <algorithm>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/earth.hpp"

namespace drydock::consistency {
namespace {

constexpr std::chrono::milliseconds push_period{24};
constexpr double quick_pull_s = 3, quick_mean_s = 2;
constexpr double quick_sigma = 1 * units::degree, usual_after_s = 30;
constexpr double quick_s = 2, slow_s = 60;  // time constants of the pull at first and later
constexpr double earth_memory_s = 600;      // of the Earth's turn; slower than the pull
constexpr double longest_bridge_s = 1;      // over a hole the rates are taken as linear
constexpr double most_unknown_turn = 0.5 * units::degree;  // of the level by holes
constexpr double most_difference_mps2 = 0.5;  // that teaches the Earth's turn; more is no noise
constexpr double whole_share = 0.999;         // of a step: it has all its samples
constexpr double steepest = 0.9;              // of the body's x against the level

std::chrono::nanoseconds gap_of_unit(const Sensor& sensor) {
  return measurement::from_seconds(std::max(0.1, 3.1 / std::max(sensor.rate_hz, 0.1)));
}

/// A sample is missing.
std::chrono::nanoseconds hole_of_unit(const Sensor& sensor) {
  return measurement::from_seconds(std::max(0.1, 1.6 / std::max(sensor.rate_hz, 0.1)));
}

/// What a body may have turned in a hole otherwise than at the mean of the rates on both sides, or
/// than not at all, if the sum leaves it out.
double unknown_turn(const Eigen::Vector3d& before, const Eigen::Vector3d& after, double hole_s) {
  if (hole_s > longest_bridge_s) return std::max(before.norm(), after.norm()) * hole_s;
  return (after - before).norm() * hole_s / 2;
}

}  // namespace

InertialUnit::InertialUnit(std::uint16_t device, const Sensor& sensor)
    : device_(device),
      longest_gap_(gap_of_unit(sensor)),
      hole_(hole_of_unit(sensor)),
      sums_(longest_gap_ + push_period) {}

void InertialUnit::take(const measurement::ImuSample& sample) {
  const Stamp at = sample.origin.valid_at;
  if (!sample.angular_rate.allFinite() || !sample.specific_force.allFinite()) return;
  freeze_.see(at, (sample.angular_rate - last_rate_).cwiseAbs().sum() +
                      (sample.specific_force - last_force_).cwiseAbs().sum());
  const double dt = measurement::seconds(at - last_sample_);
  if (at > last_sample_ && dt <= longest_bridge_s) {
    sum_.head<3>() += dt / 2 * (sample.angular_rate + last_rate_);
    sum_.segment<3>(3) += dt / 2 * (sample.specific_force + last_force_);
    if (at - last_sample_ <= longest_gap_) sum_[6] += dt;
  }
  if (at > last_sample_ + hole_ && dt < 2 * longest_bridge_s)
    sum_[7] += std::pow(unknown_turn(last_rate_, sample.angular_rate, dt), 2);
  last_rate_ = sample.angular_rate;
  last_force_ = sample.specific_force;
  last_sample_ = at;
  if (at < next_push_ && next_push_ - at <= push_period) return;
  sums_.push(at, sum_);
  next_push_ = at + push_period;
}

bool InertialUnit::advance(Stamp at) {
  const bool ran = running_;
  running_ = false;
  const auto sums = sums_.at(at);
  if (!sums) return false;
  dt_ = measurement::seconds(at - last_);
  if (!begun_ || dt_ <= 0 || dt_ > longest_bridge_s) {
    if (begun_) lose_level();
    begun_ = true;
    begin(at, sums->value);
    return false;
  }
  const Sums gone = sums->value - at_last_;
  rate_ = gone.head<3>() / dt_;
  force_ = gone.segment<3>(3) / dt_;
  begin(at, sums->value);
  serial_ = sums->serial;
  turn(dt_);
  note_unknown_turn(gone[7]);
  holed_ = !ran;
  return running_ = gone[6] > whole_share * dt_;
}

void InertialUnit::begin(Stamp at, const Sums& sums) {
  last_ = at;
  at_last_ = sums;
}

/// The pull undoes it as it undoes other errors of the level.
void InertialUnit::note_unknown_turn(double variance) {
  level_variance_ += variance - level_variance_ * std::min(1.0, 2 * dt_ / slow_s);
  if (level_variance_ > most_unknown_turn * most_unknown_turn) lose_level();
}

bool InertialUnit::settled() const { return levelled_s_ >= slow_s; }

double InertialUnit::level_sigma() const {
  const bool behind_fault = level_anew_ && levelled_s_ < usual_after_s;
  return behind_fault ? quick_sigma * quick_pull_s / std::max(levelled_s_, dt_) : 0;
}

void InertialUnit::take_quick_level() {
  down_ = quick_;
  levelled_s_ = std::min(levelled_s_, quick_pull_s);
  level_anew_ = true;
}

void InertialUnit::follow_heading(double heading) {
  axes_heading_ = heading;
  cos_heading_ = std::cos(heading), sin_heading_ = std::sin(heading);
}

void InertialUnit::lose_level() {
  level_lost_ = level_anew_ = true;
  levelled_s_ = level_variance_ = 0;
  quick_difference_.setZero();
}

/// down' = -w x down; the heading's rate is the rate about the vertical. `middle_` is the mean over
/// the step, as rate and specific force are.
void InertialUnit::turn(double dt) {
  const double by = rate_.dot(down_) * dt / std::max(0.1, down_.squaredNorm());
  heading_ += by;
  follow_heading(axes_heading_ + by);
  const Eigen::Vector3d before = down_;
  const auto axes = level_axes();
  const Eigen::Vector3d rate = axes ? Eigen::Vector3d(rate_ - *axes * earth_turn_) : rate_;
  const double angle = rate.norm() * dt;
  if (angle > 0) {
    const Eigen::AngleAxisd turned(-angle, rate.normalized());
    down_ = turned * down_;
    quick_ = turned * quick_;
  }
  middle_ = (before + down_).normalized();
}

std::optional<Eigen::Matrix<double, 3, 2>> InertialUnit::level_axes() const {
  if (std::abs(down_.x()) > steepest) return {};
  const Eigen::Vector3d ahead = (Eigen::Vector3d::UnitX() - down_.x() * down_).normalized();
  const Eigen::Vector3d starboard = down_.cross(ahead);
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = cos_heading_ * ahead - sin_heading_ * starboard;
  axes.col(1) = sin_heading_ * ahead + cos_heading_ * starboard;
  return axes;
}

/// In the level's equilibrium the pull undoes what the Earth turns: e / 60 s = w x down. No more
/// than the Earth's rate is learned, so a gyro's fault stays a fault.
void InertialUnit::learn_earth_turn(const Eigen::Vector3d& difference) {
  const auto axes = level_axes();
  if (!axes || levelled_s_ < slow_s) return;
  const double share = std::min(1.0, most_difference_mps2 / std::max(1e-9, difference.norm()));
  const Eigen::Vector3d lacking =
      share * difference.cross(down_) / units::standard_gravity / slow_s;
  earth_turn_ += axes->transpose() * lacking * (dt_ / earth_memory_s);
  const double most = frame::wgs84::earth_rate_radps;
  if (earth_turn_.norm() > most) earth_turn_ *= most / earth_turn_.norm();
}

Eigen::Vector3d InertialUnit::level(const Eigen::Vector3d& acceleration, bool pull) {
  const Eigen::Vector3d gravity = acceleration - force_;
  if (levelled_s_ <= 0 && gravity.norm() > 1) {
    down_ = middle_ = quick_ = gravity.normalized();
    level_lost_ = false;
  }
  Eigen::Vector3d difference = units::standard_gravity * middle_ - gravity;
  const auto pulled = [&](const Eigen::Vector3d& down, const Eigen::Vector3d& by, double memory_s) {
    return (down - by / units::standard_gravity * std::min(1.0, dt_ / memory_s)).normalized();
  };
  const Eigen::Vector3d quick = units::standard_gravity * quick_ - gravity;
  quick_difference_ += (quick - quick_difference_) * std::min(1.0, dt_ / quick_mean_s);
  quick_ = pulled(quick_, quick, quick_pull_s);
  if (!pull) return difference;
  levelled_s_ += dt_;
  learn_earth_turn(difference);
  down_ = pulled(down_, difference, std::clamp(levelled_s_, quick_s, slow_s));
  return difference;
}

}  // namespace drydock::consistency
