#include "estimators/pipeline/inertial/navigation_estimator.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/pipeline/inertial/bridged_gap.hpp"

namespace drydock::pipeline {

using Eigen::Vector3d;
using measurement::ImuSample;
using measurement::seconds;
using measurement::Stamp;

namespace {

/// After this many samples in a row from the past, the clock was set back. Fewer are late samples.
constexpr int clock_back_after = 10;

}  // namespace

std::string fault_of(const InertialOptions& options) {
  const auto index = [](const std::optional<AidingSensor>& sensor) {
    return sensor ? std::optional{sensor->device} : std::nullopt;
  };
  if (std::string fault =
          fault_of_devices({index(options.ground), index(options.log), index(options.depth),
                            index(options.gnss), index(options.heading), options.actuators});
      !fault.empty())
    return fault;
  if (!(options.imu_period_s > 0)) return "IMU period not above 0, allowed: seconds";
  if (options.method == InertialMethod::sensors) {
    return options.ground || options.depth || options.gnss
               ? ""
               : "nothing aids it, allowed: dvl, depth, gnss = devices, one at least";
  }
  return options.log && options.depth && options.actuators
             ? ""
             : "velocity needs log, depth and actuators, allowed: = devices";
}

std::unique_ptr<Estimator> make_estimator(Seat seat, const InertialOptions& options,
                                          const PipelineOptions& pipeline) {
  return std::make_unique<NavigationEstimator>(seat, options, pipeline);
}

NavigationEstimator::NavigationEstimator(Seat seat, const InertialOptions& options,
                                         const PipelineOptions& pipeline)
    : index_(seat.index),
      imu_(seat.imu),
      options_(options),
      period_(measurement::from_seconds(options.imu_period_s)),
      max_imu_gap_(pipeline.max_imu_gap),
      max_age_(pipeline.max_speed_age),
      gate_(pipeline.vehicle),
      alert_(pipeline.alert),
      filter_(make_aided_inertial(options)) {
  if (options.method != InertialMethod::sensors) vehicle_.emplace(options.vehicle);
  // Until the first actuator state: rudder and planes at zero, propeller at the speed of the start.
  control_.u_c = (options_.start.body_to_ned.conjugate() * options_.start.velocity_ned).x();
  filter_->control(control_);
}

Outcome NavigationEstimator::take(const ImuSample& sample, EstimateListener& listener) {
  if (sample.origin.device != imu_ || status_.state == EstimatorState::lost) return Outcome::unused;
  if (!sample.specific_force.allFinite() || !sample.angular_rate.allFinite())
    return Outcome::refused;
  const Stamp at = sample.origin.valid_at;
  if (last_ && at <= now_) {
    if (clock_was_set_back(at)) lose();
    return Outcome::late;
  }
  if (last_ && at - now_ > max_imu_gap_) {
    lose();
    return Outcome::unused;
  }
  far_behind_ = 0;
  if (!passes_gate(sample)) return Outcome::refused;
  noise_.add(sample);
  const ImuSample used = without_step(sample);
  if (last_) {
    go_on(used, listener);
  } else {
    begin(used);
  }
  last_ = used;
  return Outcome::accepted;
}

void NavigationEstimator::begin(const ImuSample& sample) {
  status_.state = EstimatorState::running;
  fed_by_ = 0;
  note_fed_by(imu_);
  now_ = step_began_ = sample.origin.valid_at;
  rate_ = sample.angular_rate;
  if (!options_.imu_means) return;
  step_began_ -= period_;
  add(sample.angular_rate, sample.specific_force, Vector3d::Zero(), options_.imu_period_s);
}

void NavigationEstimator::go_on(const ImuSample& sample, EstimateListener& listener) {
  const Stamp from = now_;
  const auto interval = sample.origin.valid_at - from;
  const bool bridges = interval > period_ + period_ / 2;
  const bool as_sampled = options_.imu_means && !bridges;
  const Vector3d rate =
      as_sampled ? sample.angular_rate : 0.5 * (last_->angular_rate + sample.angular_rate);
  const Vector3d force =
      as_sampled ? sample.specific_force : 0.5 * (last_->specific_force + sample.specific_force);
  const auto pieces = std::max<std::int64_t>(1, (interval + period_ / 2) / period_);
  const Vector3d rate_change =
      (sample.angular_rate - last_->angular_rate) / static_cast<double>(pieces);
  if (bridges) {
    const BridgedGap gap(seconds(interval));
    filter_->loosen(gap.velocity_sigma_mps, gap.angle_sigma_rad);
  }
  for (std::int64_t i = 1; i <= pieces; ++i) {
    end_step_if_due(listener);
    const Stamp to = from + interval * i / pieces;
    add(rate, force, rate_change, seconds(to - now_));
    now_ = to;
  }
  rate_ = sample.angular_rate;
}

void NavigationEstimator::add(const Vector3d& rate, const Vector3d& force,
                              const Vector3d& rate_change, double dt) {
  // Moves the specific force from the IMU to the origin of the vehicle. The sum of the terms with
  // the change of the rate has no error.
  const Vector3d& arm = options_.imu_lever;
  const Vector3d by_lever = rate_change.cross(arm) + dt * rate.cross(rate.cross(arm));
  const Vector3d at_origin = dt * force - by_lever;
  filter_->add_imu(dt * rate, at_origin, dt);
  if (vehicle_) vehicle_->add_imu(dt * rate, at_origin, rate, dt);
}

void NavigationEstimator::end_step_if_due(EstimateListener& listener) {
  const auto half = period_ / 2;
  const auto is_due = [&](const Aiding& aiding) { return aiding.valid_at <= now_ + half; };
  const bool full = now_ - step_began_ >= measurement::from_seconds(step_s) - half;
  if (now_ == step_began_ || (!full && std::ranges::none_of(waiting_, is_due))) return;
  filter_->step();
  const double lasted_s = seconds(now_ - step_began_);
  widen_by_noise(lasted_s);
  step_began_ = now_;
  for (const Aiding& aiding : waiting_)
    if (is_due(aiding)) apply(aiding, listener);
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_due), waiting_.end());
  watch_.add(Aid::model, filter_->settle(), now_);
  judge(lasted_s);
  emit(listener);
}

void NavigationEstimator::apply(const Aiding& aiding, EstimateListener& listener) {
  note_fed_by(aiding.sensor->device);
  tell(aiding.kind, aiding.valid_at, aiding.sensor->device, update(aiding), listener);
}

void NavigationEstimator::tell(Aid aid, Stamp valid_at, std::uint16_t device,
                               const Innovations& rows, EstimateListener& listener) {
  watch_.add(aid, rows, now_);
  if (!rows.empty()) listener.on_innovation({valid_at, index_, device, rows});
}

Innovations NavigationEstimator::update(const Aiding& aiding) {
  const AidingSensor& sensor = *aiding.sensor;
  if (aiding.kind == Aid::position) {
    const double age_s = seconds(now_ - aiding.valid_at);
    const auto moved = frame::at_ned_offset(aiding.position, age_s * filter_->state().velocity_ned);
    return filter_->update_position(moved, aiding.value, sensor.lever);
  }
  if (aiding.kind == Aid::heading) return filter_->update_heading(aiding.value.x());
  status_.last_speed = aiding.valid_at;
  const Vector3d of_origin = aiding.value - turning_speed(sensor.lever);
  if (aiding.kind == Aid::log) return filter_->update_log(of_origin.x());
  return filter_->update_ground(of_origin);
}

bool NavigationEstimator::clock_was_set_back(Stamp at) {
  far_behind_ = now_ - at > max_imu_gap_ ? far_behind_ + 1 : 0;
  return far_behind_ >= clock_back_after;
}

void NavigationEstimator::lose() {
  status_.state = EstimatorState::lost;
  status_.valid = false;
  status_.lost_at = now_;
  waiting_.clear();
}

void NavigationEstimator::emit(EstimateListener& listener) {
  ++status_.estimates;
  status_.last_estimate = now_;
  status_.rejected = filter_->rejected();
  status_.taken = filter_->taken();
  NavigationEstimate estimate;
  estimate.valid_at = now_;
  estimate.estimator = index_;
  filter_->fill(estimate);
  if (vehicle_) {
    vehicle_->step(estimate, filter_->gyro_bias());
    vehicle_trust_.judge(vehicle_->contradicts(), now_);
  }
  estimate.fed_by = fed_by_;
  estimate.integrity = integrity_of(estimate);
  status_.valid = estimate.integrity.valid;
  status_.valid_estimates += status_.valid ? 1 : 0;
  listener.on_navigation(estimate);
}

}  // namespace drydock::pipeline
