#include <algorithm>
#include <cmath>

#include "estimators/pipeline/reckoning/dead_reckoning_estimator.hpp"

/// How dead reckoning goes on from one speed to the next.
namespace drydock::pipeline {

using Eigen::Vector2d;
using Eigen::Vector3d;
using measurement::seconds;

namespace {

/// After this many speeds in a row from the past, the clock was set back. Fewer are late ones.
constexpr int clock_set_back_after = 10;

/// An unknown heading keeps its error for about this time, and no less than it is old.
constexpr double least_aside_s = 1;

/// A finding says that headings come late: this is one sigma of how late.
constexpr double late_heading_s = 1;

/// The mean of a velocity that goes from one to the other in `dt`, while the vehicle turns evenly
/// by `turn_rad`: Simpson's rule, whose middle is the mean of both in the vehicle's axes there. A
/// line between the ends alone would cut the curve short.
Vector2d mean_over_turn(const Vector2d& from, const Vector2d& to, double turn_rad) {
  const Eigen::Rotation2Dd half(turn_rad / 2);
  const Vector2d middle = (half * from + half.inverse() * to) / 2;
  return (from + 4 * middle + to) / 6;
}

TurnedWay::Horizontal in_axes_of(double heading_rad, const Vector2d& ned) {
  return TurnedWay::Horizontal{ned.x(), ned.y()} * std::polar(1.0, -heading_rad);
}

}  // namespace

/// Brownian motion of 10 degrees per root second, and a way's mean of it. Chosen.
double unseen_turn_rad(double dt) {
  constexpr double rad_per_root_s = 0.1745;
  return std::min(1.0, rad_per_root_s * std::sqrt(dt / 3));
}

Outcome DeadReckoningEstimator::go_on(const Speed& speed, EstimateListener& listener) {
  if (last_ && speed.valid_at <= last_->valid_at) {
    const bool far = last_->valid_at - speed.valid_at > gap_;
    far_behind_ = far ? far_behind_ + 1 : 0;
    if (far_behind_ < clock_set_back_after) return Outcome::late;
    ++status_.restarts;  // how long it was away is not known
    last_.reset();
  }
  far_behind_ = 0;
  if (!position_ && (options_.start || fixed_)) begin(speed);
  if (!position_) return Outcome::unused;
  turned_.turn_to(speed.heading_rad, speed.valid_at);
  if (last_) move(speed, seconds(speed.valid_at - last_->valid_at));
  last_ = speed;
  turned_.begin(speed.heading_rad, speed.valid_at);
  status_.state = EstimatorState::running;
  status_.last_speed = speed.valid_at;
  emit(listener);
  return Outcome::accepted;
}

/// A position of an earlier time is carried to the first speed by that speed. A start that was
/// given is of the first measurement's time; when that is long ago, nobody knows.
void DeadReckoningEstimator::begin(const Speed& first) {
  const frame::Position origin =
      fixed_ ? frame::at_ned_offset(fixed_->antenna, -arm(options_.gnss)) : *options_.start;
  position_ = frame::at_ned_offset(origin, arm(place()));
  const double sigma = options_.depth_sigma_m;
  down_variance_ = sigma * sigma;
  const double dt = seconds(first.valid_at - (fixed_ ? fixed_->valid_at : *begun_at_));
  if (dt > 0 && (fixed_ || dt <= options_.gap_s)) carry_to(first, dt, 0);
  follow_depth(first.valid_at);
  fixed_.reset();
}

void DeadReckoningEstimator::carry_to(const Speed& first, double dt, double turned_rad) {
  WayNoise noise = noise_of(first, dt);
  const double aside_m = dt * first.ned.head<2>().norm() * turned_rad;
  noise.wandered_m2 = filter_.wandered_behind(dt) + aside_m * aside_m;
  const Vector2d way = filter_.move(first.ned.head<2>(), dt, first.over, noise);
  position_ = frame::at_ned_offset(*position_, {way.x(), way.y(), dt * first.ned.z()});
  down_variance_ += filter_.wandered_behind(dt);
}

/// The place whose speed is known: the track is its way.
const std::optional<ReckoningDevice>& DeadReckoningEstimator::place() const {
  return options_.dvl ? options_.dvl : options_.log;
}

/// How much faster the log goes than the place, because the vehicle turns.
Vector3d DeadReckoningEstimator::rotation_at_log() const {
  return Vector3d(0, 0, angles_.turn_radps()).cross(arm(options_.log) - arm(place()));
}

Vector3d DeadReckoningEstimator::arm(const std::optional<ReckoningDevice>& device) const {
  return device ? frame::body_to_ned(attitude_) * device->lever : Vector3d::Zero();
}

void DeadReckoningEstimator::move(const Speed& speed, double dt) {
  const bool gap = dt > options_.gap_s;
  if (gap) note_gap(dt);
  if (gap && fixed_) return begin_at_fix(speed);
  Vector2d from = last_->ned.head<2>();
  if (last_->over != speed.over)
    from = filter_.as_measured(filter_.over_ground(from, last_->over), speed.over);
  const double turn = frame::wrap_pi(speed.heading_rad - last_->heading_rad);
  const Vector2d mean =
      gap ? mean_over_gap(from, speed) : mean_over_turn(from, speed.ned.head<2>(), turn);
  WayNoise noise = noise_of(speed, dt);
  if (turned_.longest_s() > options_.gap_s) {
    const double fastest = std::max(from.norm(), speed.ned.head<2>().norm());
    noise.wandered_m2 += std::pow(fastest * dt * unseen_turn_rad(dt / 4), 2);  // both ends told
  }
  const Vector2d way = filter_.move(mean, dt, speed.over, noise);
  const double down = dt * (last_->ned.z() + speed.ned.z()) / 2;
  position_ = frame::at_ned_offset(*position_, {way.x(), way.y(), down});
  const double tilted = options_.tilt_sigma_rad * way.norm();
  const double sigma = std::sqrt(down_variance_) + tilted;
  down_variance_ = sigma * sigma + filter_.wandered_between(dt);
  follow_depth(speed.valid_at);
}

/// Over a gap of speeds the vehicle turned as its headings say. Over a gap of headings it may have
/// turned anywhere: the way is then a line.
Vector2d DeadReckoningEstimator::mean_over_gap(const Vector2d& from, const Speed& to) const {
  const Vector2d end = to.ned.head<2>();
  if (turned_.longest_s() > options_.gap_s) return (from + end) / 2;
  const auto mean =
      turned_.mean(in_axes_of(last_->heading_rad, from), in_axes_of(to.heading_rad, end));
  return {mean.real(), mean.imag()};
}

WayNoise DeadReckoningEstimator::noise_of(const Speed& speed, double dt) const {
  const double mps = speed.ned.head<2>().norm();
  return {.wandered_m2 = filter_.wandered_between(dt),
          .aside_mps = mps * unseen_heading_rad(speed.valid_at),
          .aside_s = least_aside_s,
          .wrong_mps = doubted_mps(speed.over, speed.valid_at)};
}

double DeadReckoningEstimator::unseen_heading_rad(Stamp at) const {
  const double late = heading_doubted_ ? late_heading_s * angles_.turn_radps() : 0;
  return std::hypot(angles_.unknown_turn_rad(at), late);
}

/// How far a speed may be wrong: it made a step, log and DVL contradict each other, or the current
/// that is added to the log's was learned anew from what may have been an error of the DVL.
double DeadReckoningEstimator::doubted_mps(SpeedOver over, Stamp at) const {
  constexpr std::chrono::minutes forgotten_after{5};
  const auto fresh = [&](const std::optional<Stamp>& since) {
    return since && at - *since <= forgotten_after;
  };
  const double own = over == SpeedOver::ground ? dvl_gate_.doubted_mps(at)
                     : fresh(loosened_at_)     ? loosened_mps_
                                               : 0;
  const bool split = fresh(speeds_split_at_);
  return std::max(own, split || !speeds_.agrees(at) ? speeds_off_mps_ : 0);
}

/// In the gap a fix came: what was before it counts no more.
void DeadReckoningEstimator::begin_at_fix(const Speed& first) {
  const double height_m = position_->height_m;
  position_ = frame::at_ned_offset(fixed_->antenna, arm(place()) - arm(options_.gnss));
  position_->height_m = height_m;
  filter_.begin_at_fix(fixed_->sigma_m);
  const double dt = seconds(first.valid_at - fixed_->valid_at);
  carry_to(first, dt, unseen_turn_rad(dt));
  fixed_.reset();
  follow_depth(first.valid_at);
}

void DeadReckoningEstimator::follow_depth(Stamp at) {
  if (!depth_at_ || !is_recent(*depth_at_, at)) return;
  const double below_m = arm(place()).z() - arm(options_.depth).z();
  position_->height_m = options_.sea_level_m - depth_m_ - below_m;
  down_variance_ = options_.depth_sigma_m * options_.depth_sigma_m;
}

void DeadReckoningEstimator::note_gap(double dt) {
  ++status_.bridged;
  status_.bridged_s += dt;
  status_.longest_bridged_s = std::max(status_.longest_bridged_s, dt);
}

}  // namespace drydock::pipeline
