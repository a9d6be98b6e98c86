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

/// True for a device that the estimator has, and whose sample this is.
bool is_from(const std::optional<ReckoningDevice>& device, const measurement::Origin& origin) {
  return device && device->index == origin.device;
}

/// The mean of a velocity that goes from one to the other in `dt`, while the vehicle turns evenly
/// by `turn_rad`: Simpson's rule, whose middle is the mean of both in the vehicle's axes there. A
/// line between the ends alone would cut the curve short.
Vector2d mean_over_turn(const Vector2d& from, const Vector2d& to, double turn_rad) {
  const Eigen::Rotation2Dd half(turn_rad / 2);
  const Vector2d middle = (half * from + half.inverse() * to) / 2;
  return (from + 4 * middle + to) / 6;
}

void take_angle(const std::optional<double>& told, double& angle) {
  if (told && std::isfinite(*told)) angle = *told;
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
  if (!is_from(options_.dvl, track.origin)) return Outcome::unused;
  note_attitude(track);
  const Stamp at = track.origin.valid_at;
  if (!track.velocity || !knows_heading(at)) return Outcome::unused;
  if (!is_speed(*track.velocity)) return Outcome::refused;
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
  if (!is_from(options_.log, water.origin) || !water.longitudinal_mps) return Outcome::unused;
  const Stamp at = water.origin.valid_at;
  const Vector3d body{*water.longitudinal_mps, water.transverse_mps.value_or(0), 0};
  if (!is_speed(body)) return Outcome::refused;
  if (!knows_heading(at)) return Outcome::unused;
  const Speed speed{at, frame::body_to_ned(attitude_) * body, attitude_.yaw, SpeedOver::water};
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

/// The DVL's own compass and tilt sensors count only where no other ones tell the same. They are
/// those of its head.
void DeadReckoningEstimator::note_attitude(const measurement::BottomVelocity& track) {
  frame::Euler head;
  if (track.roll_rad && track.pitch_rad) {
    take_angle(track.roll_rad, head.roll);
    take_angle(track.pitch_rad, head.pitch);
  }
  const bool own_heading =
      !options_.heading && track.heading_rad && std::isfinite(*track.heading_rad);
  if (own_heading) head.yaw = *track.heading_rad + options_.variation_rad;
  // The rows of these matrices are the axes of head and body in NED.
  const auto body =
      frame::euler(Eigen::Matrix3d(options_.dvl->sensor_to_body * frame::ned_to_body(head)));
  if (!tilt_told_) {
    attitude_.roll = body.roll;
    attitude_.pitch = body.pitch;
  }
  if (!own_heading) return;
  attitude_.yaw = body.yaw;
  heading_at_ = track.origin.valid_at;
}

Outcome DeadReckoningEstimator::take(const measurement::AttitudeSample& sample, EstimateListener&) {
  if (!is_from(options_.heading, sample.origin)) return Outcome::unused;
  take_angle(sample.roll_rad, attitude_.roll);
  take_angle(sample.pitch_rad, attitude_.pitch);
  tilt_told_ |= sample.roll_rad && sample.pitch_rad;
  const auto magnetic = sample.heading_rad;
  if (!sample.true_heading_rad && !magnetic) {
    return sample.roll_rad || sample.pitch_rad ? Outcome::accepted : Outcome::unused;
  }
  const double heading =
      sample.true_heading_rad ? *sample.true_heading_rad : *magnetic + options_.variation_rad;
  if (!std::isfinite(heading)) return Outcome::refused;
  attitude_.yaw = frame::wrap_pi(heading);
  heading_at_ = sample.origin.valid_at;
  note_fed_by(options_.heading);
  return Outcome::accepted;
}

Outcome DeadReckoningEstimator::take(const measurement::DepthSample& sample, EstimateListener&) {
  if (!is_from(options_.depth, sample.origin) || !sample.depth_m) return Outcome::unused;
  if (!std::isfinite(*sample.depth_m)) return Outcome::refused;
  depth_m_ = *sample.depth_m;
  depth_at_ = sample.origin.valid_at;
  note_fed_by(options_.depth);
  return Outcome::accepted;
}

Outcome DeadReckoningEstimator::take(const measurement::GnssFix& fix, EstimateListener& listener) {
  if (!is_from(options_.gnss, fix.origin) || !fix.position) return Outcome::unused;
  const double sigma = fix.horizontal_accuracy_m.value_or(options_.fix_sigma_m);
  const frame::Position antenna{fix.position->latitude_rad, fix.position->longitude_rad,
                                position_ ? position_->height_m : options_.sea_level_m};
  if (!(sigma > 0) || !std::isfinite(antenna.latitude_rad + antenna.longitude_rad))
    return Outcome::refused;
  const frame::Position origin = frame::at_ned_offset(antenna, -arm(options_.gnss));
  note_fed_by(options_.gnss);
  if (!position_) {
    options_.errors.position_m = sigma;
    filter_ = ReckoningFilter(options_.errors);
    start_at(origin);
    return Outcome::accepted;
  }
  const double age_s = last_ ? seconds(fix.origin.valid_at - last_->valid_at) : 0;
  if (age_s < -options_.gap_s) return Outcome::late;
  const auto& place = options_.dvl ? options_.dvl : options_.log;
  Vector2d offset =
      frame::ned_offset(*position_, frame::at_ned_offset(origin, arm(place))).head<2>();
  if (last_) offset -= age_s * filter_.over_ground(last_->ned.head<2>(), last_->over);
  // The vehicle may have changed its speed since the last one.
  const double wandered = options_.errors.wander * std::sqrt(std::pow(std::abs(age_s), 3) / 3);
  const auto rows = filter_.fix(offset, std::hypot(sigma, wandered));
  for (const auto& row : rows) status_.taken.add(row.normalised_square());
  const double height_m = position_->height_m;
  position_ = frame::at_ned_offset(*position_, {offset.x(), offset.y(), 0});
  position_->height_m = height_m;
  listener.on_innovation({fix.origin.valid_at, index_, fix.origin.device, rows});
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
  if (!position_ && options_.start) start_at(*options_.start);
  if (!position_) return Outcome::unused;
  if (last_) move(speed, seconds(speed.valid_at - last_->valid_at));
  last_ = speed;
  status_.state = EstimatorState::running;
  status_.last_speed = speed.valid_at;
  emit(listener);
  return Outcome::accepted;
}

void DeadReckoningEstimator::start_at(const frame::Position& origin) {
  const auto& place = options_.dvl ? options_.dvl : options_.log;
  position_ = frame::at_ned_offset(origin, arm(place));
  down_variance_ = options_.depth_sigma_m * options_.depth_sigma_m;
}

Vector3d DeadReckoningEstimator::arm(const std::optional<ReckoningDevice>& device) const {
  return device ? frame::body_to_ned(attitude_) * device->lever : Vector3d::Zero();
}

void DeadReckoningEstimator::move(const Speed& speed, double dt) {
  if (dt > options_.gap_s) note_gap(dt);
  Vector2d from = last_->ned.head<2>();
  if (last_->over != speed.over) {
    const Vector2d ground = filter_.over_ground(from, last_->over);
    from = speed.over == SpeedOver::ground ? ground : Vector2d(ground - filter_.current());
  }
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
  if (!depth_at_ || !is_recent(*depth_at_, speed.valid_at)) return;
  const auto& place = options_.dvl ? options_.dvl : options_.log;
  const double below_m = arm(place).z() - arm(options_.depth).z();
  position_->height_m = options_.sea_level_m - depth_m_ - below_m;
  down_variance_ = options_.depth_sigma_m * options_.depth_sigma_m;
}

void DeadReckoningEstimator::note_gap(double dt) {
  ++status_.bridged;
  status_.bridged_s += dt;
  status_.longest_bridged_s = std::max(status_.longest_bridged_s, dt);
}

NavigationEstimate DeadReckoningEstimator::estimate() const {
  NavigationEstimate estimate;
  estimate.valid_at = last_->valid_at;
  estimate.estimator = index_;
  const auto& place = options_.dvl ? options_.dvl : options_.log;
  estimate.position = frame::at_ned_offset(*position_, -arm(place));
  const Vector2d measured = last_->ned.head<2>();
  const Vector2d ground = filter_.over_ground(measured, last_->over);
  estimate.velocity_ned = {ground.x(), ground.y(), last_->ned.z()};
  frame::Euler corrected = attitude_;
  corrected.yaw = frame::wrap_pi(attitude_.yaw + filter_.heading_error());
  estimate.body_to_ned = frame::body_to_ned(corrected);
  const auto& covariance = filter_.covariance();
  const double tilt = options_.tilt_sigma_rad * options_.tilt_sigma_rad;
  const double speed_noise = options_.errors.velocity_mps * options_.errors.velocity_mps;
  auto& p = estimate.covariance;
  p.topLeftCorner<2, 2>() = covariance.topLeftCorner<2, 2>();
  p(2, 2) = down_variance_;
  p.block<2, 2>(3, 3) = filter_.velocity_covariance(measured, last_->over);
  p(5, 5) = speed_noise + tilt * ground.squaredNorm();
  p(6, 6) = p(7, 7) = tilt;
  p(8, 8) = covariance(2, 2);
  if (options_.log) {
    estimate.current =
        CurrentEstimate{filter_.current(), covariance.diagonal().tail<2>().cwiseMax(0).cwiseSqrt()};
  }
  estimate.fed_by = fed_by_;
  estimate.integrity = integrity_of(estimate);
  return estimate;
}

Integrity DeadReckoningEstimator::integrity_of(const NavigationEstimate& estimate) const {
  const auto& p = estimate.covariance;
  Integrity integrity;
  integrity.roll_bound_rad = integrity.pitch_bound_rad = bound_of(p(6, 6));
  integrity.heading_bound_rad = bound_of(p(8, 8));
  integrity.horizontal_bound_m = bound_of(std::max(p(0, 0), p(1, 1)));
  // The comparison is false for NaN too.
  integrity.valid = *integrity.heading_bound_rad <= alert_.attitude_rad &&
                    bound_of(std::max(p(3, 3), p(4, 4))) <= alert_.velocity_mps;
  return integrity;
}

void DeadReckoningEstimator::emit(EstimateListener& listener) {
  const NavigationEstimate told = estimate();
  ++status_.estimates;
  status_.last_estimate = told.valid_at;
  status_.valid = told.integrity.valid;
  status_.valid_estimates += status_.valid ? 1 : 0;
  listener.on_navigation(told);
}

void DeadReckoningEstimator::note_fed_by(const std::optional<ReckoningDevice>& device) {
  fed_by_ |= mask(device->index);
}

}  // namespace drydock::pipeline
