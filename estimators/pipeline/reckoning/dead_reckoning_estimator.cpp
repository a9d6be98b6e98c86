#include "estimators/pipeline/reckoning/dead_reckoning_estimator.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::pipeline {

using Eigen::Vector2d;
using Eigen::Vector3d;
using measurement::seconds;

namespace {

/// After this many speeds in a row from the past, the clock was set back. Fewer are late ones.
constexpr int clock_set_back_after = 10;

std::uint32_t mask(std::uint16_t device) { return std::uint32_t{1} << device; }

bool is_speed(const Vector3d& v) {
  return v.allFinite() && v.cwiseAbs().maxCoeff() <= DeadReckoningEstimator::max_speed_mps;
}

/// The mean of a velocity that goes from one to the other in `dt`, while the vehicle turns evenly
/// by `turn_rad`: Simpson's rule, whose middle is the mean of both in the vehicle's axes there. A
/// line between the ends alone would cut the curve short.
Vector2d mean_over_turn(const Vector2d& from, const Vector2d& to, double turn_rad) {
  const Eigen::Rotation2Dd half(turn_rad / 2);
  const Vector2d middle = (half * from + half.inverse() * to) / 2;
  return (from + 4 * middle + to) / 6;
}

}  // namespace

std::string fault_of(const ReckoningOptions& options) {
  if (!options.dvl && !options.log)
    return "dead reckoning needs a speed, allowed: dvl or log = a device";
  if (!options.dvl && !options.heading)
    return "dead reckoning with a log alone needs a heading, allowed: heading = a device";
  if (!options.start && !options.gnss)
    return "dead reckoning needs a start, allowed: latitude_deg and longitude_deg, or gnss";
  for (const auto* device :
       {&options.dvl, &options.log, &options.heading, &options.depth, &options.gnss})
    if (*device)
      if (auto fault = fault_of_devices({(*device)->index}); !fault.empty()) return fault;
  return {};
}

std::unique_ptr<Estimator> make_estimator(Seat seat, const ReckoningOptions& options,
                                          const PipelineOptions& pipeline) {
  return std::make_unique<DeadReckoningEstimator>(seat, options, pipeline);
}

DeadReckoningEstimator::DeadReckoningEstimator(Seat seat, const ReckoningOptions& options,
                                               const PipelineOptions& pipeline)
    : index_(seat.index),
      options_(options),
      gap_(measurement::from_seconds(options.gap_s)),
      max_age_(pipeline.max_speed_age),
      alert_(pipeline.alert),
      filter_(options.errors) {
  status_.state = EstimatorState::waiting_for_speed;
  status_.longest_silence = gap_;
}

Outcome DeadReckoningEstimator::take(const measurement::BottomVelocity& track,
                                     EstimateListener& listener) {
  if (!is_of(options_.dvl, track.origin)) return Outcome::unused;
  const Stamp at = track.origin.valid_at;
  if (!begun_at_) begun_at_ = at;
  note_attitude(track);
  if (!track.velocity || !knows_heading(at)) return Outcome::unused;
  if (!is_speed(*track.velocity)) return Outcome::refused;
  turn_to(at);
  const Speed speed{at, frame::body_to_ned(attitude_) * *track.velocity, attitude_.yaw,
                    SpeedOver::ground};
  const Outcome outcome = go_on(speed, listener);
  if (outcome == Outcome::accepted) {
    ground_at_ = at;
    last_ground_ = speed.ned;
    note_fed_by(options_.dvl);
  }
  return outcome;
}

Outcome DeadReckoningEstimator::take(const measurement::WaterSpeed& water,
                                     EstimateListener& listener) {
  if (!is_of(options_.log, water.origin) || !water.longitudinal_mps) return Outcome::unused;
  const Stamp at = water.origin.valid_at;
  if (!begun_at_) begun_at_ = at;
  // A log that tells no speed across: the origin has none, and the log swings around it.
  const Vector3d body{*water.longitudinal_mps,
                      water.transverse_mps.value_or(turn_radps_ * options_.log->lever.x()), 0};
  if (!is_speed(body)) return Outcome::refused;
  if (!knows_heading(at)) return Outcome::unused;
  turn_to(at);
  const Vector3d ned = frame::body_to_ned(attitude_) * body - rotation_at_log();
  const Speed speed{at, ned, attitude_.yaw, SpeedOver::water};
  if (!ground_at_ || !is_recent(*ground_at_, at)) {
    const Outcome outcome = go_on(speed, listener);
    if (outcome == Outcome::accepted) note_fed_by(options_.log);
    return outcome;
  }
  if (std::chrono::abs(at - *ground_at_) > max_age_) return Outcome::unused;
  filter_.compare(last_ground_.head<2>(), speed.ned.head<2>());
  note_fed_by(options_.log);
  return Outcome::accepted;
}

bool DeadReckoningEstimator::is_recent(Stamp then, Stamp at) const {
  return std::chrono::abs(at - then) <= gap_;
}

bool DeadReckoningEstimator::knows_heading(Stamp at) const {
  return heading_at_ && is_recent(*heading_at_, at);
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
  if (last_) move(speed, seconds(speed.valid_at - last_->valid_at));
  last_ = speed;
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
  if (dt > 0 && (fixed_ || dt <= options_.gap_s)) {
    const Vector2d way = filter_.move_before(first.ned.head<2>(), dt, first.over);
    position_ = frame::at_ned_offset(*position_, {way.x(), way.y(), dt * first.ned.z()});
    const double wander = options_.errors.wander;
    down_variance_ += wander * wander * std::pow(dt, 3) / 3;
  }
  follow_depth(first.valid_at);
}

/// The place whose speed is known: the track is its way.
const std::optional<ReckoningDevice>& DeadReckoningEstimator::place() const {
  return options_.dvl ? options_.dvl : options_.log;
}

/// How much faster the log goes than the place, because the vehicle turns.
Vector3d DeadReckoningEstimator::rotation_at_log() const {
  return Vector3d(0, 0, turn_radps_).cross(arm(options_.log) - arm(place()));
}

Vector3d DeadReckoningEstimator::arm(const std::optional<ReckoningDevice>& device) const {
  return device ? frame::body_to_ned(attitude_) * device->lever : Vector3d::Zero();
}

void DeadReckoningEstimator::move(const Speed& speed, double dt) {
  if (dt > options_.gap_s) note_gap(dt);
  Vector2d from = last_->ned.head<2>();
  if (last_->over != speed.over)
    from = filter_.as_measured(filter_.over_ground(from, last_->over), speed.over);
  // Over a gap the vehicle may have turned anywhere: the way is then a line.
  const double turn =
      dt > options_.gap_s ? 0 : frame::wrap_pi(speed.heading_rad - last_->heading_rad);
  const Vector2d mean = mean_over_turn(from, speed.ned.head<2>(), turn);
  const Vector2d way = filter_.move(mean, dt, speed.over);
  const double down = dt * (last_->ned.z() + speed.ned.z()) / 2;
  position_ = frame::at_ned_offset(*position_, {way.x(), way.y(), down});
  const double tilted = options_.tilt_sigma_rad * way.norm();
  const double sigma = std::sqrt(down_variance_) + tilted;
  const double wandered = options_.errors.wander * std::sqrt(std::pow(dt, 3) / 12);
  down_variance_ = sigma * sigma + wandered * wandered;
  follow_depth(speed.valid_at);
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

void DeadReckoningEstimator::note_fed_by(const std::optional<ReckoningDevice>& device) {
  fed_by_ |= mask(device->index);
}

}  // namespace drydock::pipeline
